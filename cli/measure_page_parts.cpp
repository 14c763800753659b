#include "cli/measure_page_parts.hpp"

#include <cstdint>
#include <cstdio>

namespace vicus::measure {
namespace {

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--ink:#1b1f24;--soft:#5a636e;--paper:#faf9f6;--card:#fff;--line:#e2e0da;--accent:#0f8a5f}
@media(prefers-color-scheme:dark){:root{--ink:#e7eaee;--soft:#9aa4b0;--paper:#0f1216;--card:#16191d;--line:#2b3037;--accent:#4cc38a}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 Georgia,'DejaVu Serif',serif}
main{max-width:1040px;margin:0 auto;padding:2.5rem 1.25rem 4rem}
h1{font-size:2.5rem;line-height:1.15;margin:.2rem 0 1rem;letter-spacing:-.01em}
h2{font-size:1.6rem;margin:3.2rem 0 .6rem}
.eyebrow{font:600 .8rem/1 'DejaVu Sans',system-ui,sans-serif;letter-spacing:.12em;text-transform:uppercase;color:var(--accent);margin:0}
.lead{font-size:1.2rem;color:var(--soft);max-width:46rem}
.facts{display:flex;flex-wrap:wrap;gap:1.2rem 2.6rem;margin:1.6rem 0 0;font-family:'DejaVu Sans',system-ui,sans-serif}
.facts div{display:flex;flex-direction:column-reverse}
.facts dd{margin:0;font-size:1.5rem;font-weight:600}.facts dt{color:var(--soft);font-size:.8rem}
figure{margin:1.2rem 0}
figcaption{font:.82rem/1.45 'DejaVu Sans',system-ui,sans-serif;color:var(--soft);margin-top:.4rem}
.plot svg{width:100%;height:auto;border:1px solid var(--line);border-radius:8px;display:block}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(300px,1fr));gap:.7rem}
.pictures figure{margin:0}.pictures img{width:100%;display:block;border-radius:6px}
table{border-collapse:collapse;font:.84rem/1.4 'DejaVu Sans',system-ui,sans-serif;margin:.8rem 0;font-variant-numeric:tabular-nums}
caption{text-align:left;color:var(--soft);padding-bottom:.4rem}
th,td{padding:.3rem .7rem;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}
th:first-child,td:first-child,.budget td:nth-child(2),.budget th:nth-child(2){text-align:left}
th{font-weight:600;color:var(--soft)}
.wide{overflow-x:auto}
details{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:.6rem 1rem;margin:1rem 0}
summary{cursor:pointer;font-family:'DejaVu Sans',system-ui,sans-serif;font-size:.9rem}
li{margin:.35rem 0}
)";

}  // namespace

std::string page_head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<main>\n";
}

std::string fact(const std::string& value, const std::string& what) {
  return "<div><dt>" + escaped(what) + "</dt><dd>" + escaped(value) + "</dd></div>";
}

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string number_text(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string base64(const std::string& bytes) {
  static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kLetters[three >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

}  // namespace vicus::measure
