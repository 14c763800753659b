/**
 * The numbers of a layout header (city_db/*_layout.h), by name: the text that C++ and shaders are compiled with is the only
 * statement of a format.
 */
export const readLayout = text => Object.fromEntries(
    [...text.matchAll(/^#define (\w+)[ \t]+(\w+)/gm)].map(([, name, value]) => [name, Number(value)]));
