import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kSerious = ['serious', 'critical'];
const kLeastContrast = 4.5, kLeastLargeContrast = 3;   // WCAG 2.1, 1.4.3

/**
 * What axe calls serious or worse on the page; and what it cannot tell for sure, or not at all: contrast over the 3D window, focus
 * into what is hidden, and again names of controls, ids, roles' needs, references, headings, language, zoom. Returns sentences.
 */
export async function faultsOfPage(page) {
    if (!await page.evaluate(() => Boolean(window.axe))) await page.evaluate(readFileSync(kAxe, 'utf8'));
    const violations = await page.evaluate(async () => (await window.axe.run(document, { resultTypes: ['violations'] })).violations);
    const serious = violations.filter(({ impact }) => kSerious.includes(impact));
    const told = serious.flatMap(({ id, help, nodes }) => nodes.map(({ target }) => `axe, ${id}: ${help}: ${target.join(' ')}`));
    return [...told, ...await page.evaluate(findFaults, { least: kLeastContrast, leastLarge: kLeastLargeContrast })];
}

/* Runs in the page. */
function findFaults({ least, leastLarge }) {
    const faults = [], all = [...document.querySelectorAll('body *')], isShown = node => node.checkVisibility?.() ?? node.offsetParent !== null;
    const told = node => `${node.tagName.toLowerCase()}#${node.id || '?'}`;
    const byIds = text => text.split(/\s+/).map(id => document.getElementById(id));
    const nameOf = node => [node.getAttribute('aria-label'), ...byIds(node.getAttribute('aria-labelledby') ?? '').map(other => other?.textContent),
        ...[...(node.labels ?? [])].map(label => label.textContent), node.textContent, node.title].find(text => text?.trim()) ?? '';

    if (!document.documentElement.lang) faults.push('the page has no language');
    if (!document.title.trim()) faults.push('the page has no title');
    if (/user-scalable=no|maximum-scale=1\b/.test(document.querySelector('meta[name=viewport]')?.content)) faults.push('zooming is forbidden');
    if (document.querySelectorAll('main').length !== 1) faults.push('there is not one main');
    const ids = all.map(node => node.id).filter(Boolean);
    for (const id of new Set(ids.filter((id, i) => ids.indexOf(id) !== i))) faults.push(`two elements have the id ${id}`);
    for (const node of all) {
        for (const key of ['aria-labelledby', 'aria-controls', 'aria-describedby', 'for'])
            for (const id of (node.getAttribute(key) ?? '').split(/\s+/).filter(Boolean))
                if (!document.getElementById(id)) faults.push(`${told(node)}: ${key} leads to ${id}, which is not there`);
        const needsName = node.matches('button, input, select, a[href], canvas[role=img], [role=dialog], [role=group], [role=progressbar], aside, nav');
        if (needsName && !nameOf(node)) faults.push(`${told(node)} has no name`);
        if (node.tabIndex > 0) faults.push(`${told(node)} has a tabindex above 0`);
        if (node.closest('[aria-hidden=true]') && node.matches('button, input, select, a[href], [tabindex="0"]')) faults.push(`${told(node)} is hidden and takes the focus`);
        if (node.matches('li') && !node.parentElement.matches('ul, ol')) faults.push(`${told(node)} is in no list`);
        if (node.matches('dl > :not(div, dt, dd), ul > :not(li)')) faults.push(`${told(node)} does not belong into its list`);
        if (isShown(node) && node.matches('button, input, select') && !node.disabled) {
            const sizes = [node, ...(node.labels ?? [])].map(target => target.getBoundingClientRect());
            const { width, height } = sizes.reduce((a, b) => (Math.min(a.width, a.height) > Math.min(b.width, b.height) ? a : b));
            if (Math.min(width, height) < 24) faults.push(`${told(node)} is only ${Math.round(width)} x ${Math.round(height)} pixels large`);
        }
    }
    const levels = [...document.querySelectorAll('h1, h2, h3, h4')].filter(isShown).map(node => Number(node.tagName[1]));
    levels.forEach((level, i) => { if (level > (levels[i - 1] ?? 0) + 1) faults.push(`a heading of level ${level} follows one of ${levels[i - 1] ?? 0}`); });
    for (const node of all.filter(node => isShown(node) && [...node.childNodes].some(child => child.nodeType === 3 && child.data.trim()))) {
        const ground = groundOf(node), style = getComputedStyle(node);
        if (!ground) continue;   // over the 3D view: a shadow stands behind it
        const ratio = contrast(rgba(style.color), ground), isLarge = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && style.fontWeight >= 600);
        if (ratio < (isLarge ? leastLarge : least)) faults.push(`${told(node)} "${node.textContent.trim().slice(0, 20)}" has a contrast of ${ratio.toFixed(1)}`);
    }
    return faults;

    function rgba(text) {
        const [r, g, b, a = 1] = text.match(/[\d.]+/g).map(Number);
        return [r, g, b, a];
    }

    function groundOf(node) {
        for (let at = node; at; at = at.parentElement) {
            if (at.matches('body')) return null;
            const colour = rgba(getComputedStyle(at).backgroundColor);
            if (colour[3] >= 0.9) return colour;
        }
        return null;
    }

    function contrast(a, b) {
        const [light, dark] = [a, b].map(colour => {
            const [r, g, blue] = colour.map(v => (v / 255 <= 0.03928 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
            return 0.2126 * r + 0.7152 * g + 0.0722 * blue;
        }).sort((p, q) => q - p);
        return (light + 0.05) / (dark + 0.05);
    }
}
