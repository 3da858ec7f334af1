#include <orris/chart/gallery/gallery_page.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include <orris/chart/page/embedded.h>

namespace orris {
namespace {

constexpr std::size_t kMostFiles = 200;

std::string milliseconds(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "–";
}

/// Larger comes first: what could not be drawn or compared, then by change.
double rankOf(const GalleryEntry& entry) {
  if (!entry.after.picture) return 4;
  return entry.change ? entry.change->change + (entry.change->equal ? 0 : entry.change->rmse * 1e-6) : 3;
}

std::string figure(const char* kind, const std::string& png, const std::string& name) {
  return fmt::format("<figure class=\"{0}\"><img src=\"{1}\" alt=\"{2}, {0}\"><figcaption>{0}</figcaption></figure>\n",
                     kind, dataUri("image/png", png), htmlText(name));
}

std::string gap(const char* kind) {
  return fmt::format("<figure class=\"{0}\"><div class=\"gap\">not drawn</div><figcaption>{0}</figcaption></figure>\n", kind);
}

std::string pictures(const GalleryEntry& entry, bool against) {
  std::string text = "<div class=\"pictures\">\n";
  if (against) {
    text += entry.before.picture ? figure("before", entry.before.png, entry.name) : gap("before");
    text += entry.after.picture ? figure("after", entry.after.png, entry.name) : gap("after");
  } else {
    text += entry.after.picture ? figure("picture", entry.after.png, entry.name) : gap("picture");
  }
  if (!entry.differencePng.empty()) text += figure("difference", entry.differencePng, entry.name);
  return text + "</div>\n";
}

std::string changeText(const PictureChange& change) {
  if (change.equal) return "<strong>equal</strong>, byte for byte";
  return fmt::format("change <strong>{:.4f}</strong> (1 − SSIM of the worst channel), RMSE {:.4f}, {:.1f} % of the pixels differ",
                     change.change, change.rmse, 100 * change.share);
}

std::string costText(const GalleryEntry& entry) {
  if (!entry.after.picture) return "";
  const GalleryPicture& picture = *entry.after.picture;
  const std::string was = entry.before.picture ? fmt::format("{:.2f} → ", entry.before.picture->milliseconds) : "";
  return fmt::format("{}{:.2f} ms a frame, {} passes, {} programs", was, picture.milliseconds,
                     picture.passes.size(), picture.programs.size());
}

std::vector<PassChange> passesOf(const GalleryEntry& entry) {
  if (entry.change) return entry.change->passes;
  std::vector<PassChange> rows;
  if (entry.after.picture)
    for (const GalleryPass& pass : entry.after.picture->passes)
      rows.push_back({pass.name, Difference::Same, std::nullopt, pass.milliseconds, ""});
  return rows;
}

/// "1 added, 2 changed", or "no change".
std::string passSummary(const std::vector<PassChange>& passes) {
  std::string text;
  for (const Difference kind : {Difference::Added, Difference::Removed, Difference::Changed}) {
    const auto count = std::ranges::count(passes, kind, &PassChange::kind);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, differenceName(kind));
  }
  return text.empty() ? "none changed" : text;
}

std::string passRow(const PassChange& pass, bool compared) {
  const std::string kind = pass.kind == Difference::Same ? "" : differenceName(pass.kind);
  std::string row = fmt::format("<tr class=\"{}\"><td>{}</td>", kind, htmlText(pass.name));
  if (compared) row += fmt::format("<td>{}</td>", milliseconds(pass.before));
  row += fmt::format("<td>{}</td>", milliseconds(pass.after));
  if (compared) row += fmt::format("<td>{}{}</td>", kind, pass.why.empty() ? "" : ": " + htmlText(pass.why));
  return row + "</tr>\n";
}

std::string passTable(const GalleryEntry& entry) {
  const auto passes = passesOf(entry);
  if (passes.empty()) return "";
  const bool compared = entry.change.has_value();
  const bool differs = std::ranges::any_of(passes, [](const PassChange& pass) { return pass.kind != Difference::Same; });
  std::string text = fmt::format("<details{}><summary>Passes and programs{}</summary>\n<div class=\"scroll\"><table>\n",
                                 differs ? " open" : "", compared ? ": " + passSummary(passes) : "");
  text += compared ? "<tr><th scope=\"col\">pass</th><th scope=\"col\">ms before</th><th scope=\"col\">ms after</th>"
                     "<th scope=\"col\">text of its program</th></tr>\n"
                   : "<tr><th scope=\"col\">pass</th><th scope=\"col\">ms</th></tr>\n";
  // Those that changed stand where the eye falls first.
  for (const bool changed : {true, false})
    for (const PassChange& pass : passes)
      if ((pass.kind != Difference::Same) == changed) text += passRow(pass, compared);
  return text + "</table></div></details>\n";
}

std::string problems(const GalleryRevision& revision, const char* kind) {
  std::string text;
  for (const std::string& problem : revision.problems)
    text += fmt::format("<pre>{}{}</pre>\n", kind, htmlText(problem));
  return text;
}

std::string card(const GalleryEntry& entry, std::size_t order, bool against) {
  const double after = entry.after.picture ? entry.after.picture->milliseconds : 0;
  const double before = entry.before.picture ? entry.before.picture->milliseconds : 0;
  const std::string numbers = entry.change ? changeText(*entry.change) + "<br>" : "";
  return fmt::format("<article class=\"shot\" aria-labelledby=\"shot-{0}\" data-order=\"{0}\" data-change=\"{1}\" "
                     "data-ms=\"{2}\" data-slower=\"{3}\">\n<h2 id=\"shot-{0}\">{4}</h2>\n",
                     order, rankOf(entry), after, before > 0 ? after / before : 0, htmlText(entry.name)) +
         pictures(entry, against) + fmt::format("<p>{}{}</p>\n", numbers, costText(entry)) +
         problems(entry.after, "") + problems(entry.before, "before: ") + passTable(entry) + "</article>\n";
}

std::string fileList(const std::vector<FileChange>& files) {
  if (files.empty()) return "<p class=\"note\">No file of the pack differs.</p>\n";
  std::string text = fmt::format("<details><summary>{} file{} of the pack differ{}</summary><ul>\n", files.size(),
                                 files.size() == 1 ? "" : "s", files.size() == 1 ? "s" : "");
  for (std::size_t i = 0; i < std::min(files.size(), kMostFiles); ++i)
    text += fmt::format("<li class=\"{0}\">{0} {1}</li>\n", differenceName(files[i].kind), htmlText(files[i].file));
  if (files.size() > kMostFiles) text += fmt::format("<li>and {} more</li>\n", files.size() - kMostFiles);
  return text + "</ul></details>\n";
}

std::string heading(const Gallery& gallery) {
  std::string text = fmt::format("<h1>{}</h1>\n", htmlText(gallery.title));
  for (const auto& [name, fact] : gallery.facts)
    text += fmt::format("<p class=\"note\">{}: {}</p>\n", htmlText(name), htmlText(fact));
  if (!gallery.against) return text;
  const auto equal = std::ranges::count_if(gallery.entries, [](const GalleryEntry& entry) {
    return entry.change && entry.change->equal;
  });
  text += fmt::format("<p>{} of {} pictures are equal, byte for byte.</p>\n", equal, gallery.entries.size());
  return text + fileList(gallery.files);
}

void put(std::string& page, std::string_view mark, const std::string& text) {
  page.replace(page.find(mark), mark.size(), text);
}

}  // namespace

std::string galleryPage(const Gallery& gallery) {
  std::vector<std::size_t> order(gallery.entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (gallery.against)
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return rankOf(gallery.entries[a]) > rankOf(gallery.entries[b]);
    });
  std::string body = heading(gallery) + fmt::format("<div class=\"shots\"{}>\n", gallery.against ? " data-against" : "");
  for (const std::size_t i : order) body += card(gallery.entries[i], i, gallery.against);
  std::string page(kGalleryTemplate);
  put(page, "<!--TITLE-->", htmlText(gallery.title));
  put(page, "<!--BODY-->", body + "</div>");
  return page;
}

}  // namespace orris
