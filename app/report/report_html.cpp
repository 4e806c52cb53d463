#include "app/report/report_html.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/style.hpp"
#include "app/report/text.hpp"
#include "app/report/timeline.hpp"
#include "scenarios/drill/order.hpp"

namespace app::report {

using scenarios::drill::Placed;
using scenarios::drill::Result;
using scenarios::drill::ScoreItem;
using scenarios::drill::Standing;

namespace {

std::string cell(const std::string& kind, const std::string& words) {
    return "<td" + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + escaped(words) + "</td>";
}

std::string head(const std::vector<std::string>& titles) {
    std::string out = "<div class=\"scroll\"><table>\n<thead><tr>";
    for (const std::string& title : titles) out += "<th scope=\"col\">" + escaped(title) + "</th>";
    return out + "</tr></thead>\n<tbody>\n";
}

std::string folded(const std::string& title, const std::string& what) {
    return "<details><summary><h2>" + title + "</h2></summary>\n" + what + "</details>\n";
}

const std::string table_end = "</tbody>\n</table></div>\n";

std::string with_unit(const std::string& value, const std::string& unit) {
    return unit.empty() ? value : value + " " + unit;
}

std::string verdict(const Result& result) {
    const auto judged =
        std::count_if(result.items.begin(), result.items.end(), [](auto& item) { return !item.band.empty(); });
    const auto missed =
        std::count_if(result.items.begin(), result.items.end(), [](auto& item) { return !item.passed; });
    std::string out = "<h1>" + escaped(result.drill_title) + "</h1>\n<p class=\"verdict " +
                      (!result.finished ? "fail\">✗ Broken off, not finished"
                       : result.passed  ? "pass\">✓ Passed"
                                        : "fail\">✗ Not passed") +
                      "</p>\n";
    if (missed > 0)
        out += "<p class=\"tied\">" + std::to_string(missed) + " of " + std::to_string(judged) +
               " judged items outside their band.</p>\n";
    if (!result.surgical.empty() || !result.knot.empty()) {
        const bool is_tied = !result.surgical.empty() || result.knot != "0_1";
        out += is_tied ? "<p class=\"tied\">Tied: <strong>" +
                             escaped(result.surgical.empty() ? result.knot : result.surgical) + "</strong>"
                       : "<p class=\"tied\">Nothing is tied";
        if (!result.throws.empty()) out += ", throws " + escaped(result.throws);
        if (!result.surgical.empty() && result.knot != "0_1") out += ", in knot theory " + escaped(result.knot);
        out += ".</p>\n";
    }
    return out + "<p class=\"note\">" + number(result.duration_s, 1) + " s of simulated time.</p>\n";
}

std::string score_row(const ScoreItem& item, bool any_why) {
    const bool judged = !item.band.empty();
    const std::string sign = !item.passed ? "✗ fail" : judged ? "✓ pass" : "no band";
    return std::string(item.passed ? "<tr>" : "<tr class=\"missed\">") + "<th scope=\"row\">" + escaped(item.title) +
           "</th>" + cell("", with_unit(item.value, item.unit)) +
           cell("", judged ? with_unit(item.band, item.unit) : "–") +
           cell(!item.passed ? "sign fail"
                : judged     ? "sign pass"
                             : "",
                sign) +
           cell("number", number(item.at_s, 1) + " s") + (any_why ? cell("", item.why) : "") + "</tr>\n";
}

// All items, in their order.
std::string scores(const Result& result, const std::vector<Placed>& order) {
    if (result.items.empty()) return "";
    const bool any_why =
        std::any_of(result.items.begin(), result.items.end(), [](auto& item) { return !item.why.empty(); });
    std::vector<std::string> titles{"Item", "Value", "Band", "Verdict", "Moment"};
    if (any_why) titles.push_back("Why");
    std::string out = head(titles);
    for (const Placed& placed : order) out += score_row(result.items[placed.item], any_why);
    return folded("All scores",
                  out + table_end + "<p class=\"note\">Each item stands for itself; none is added to another.</p>\n");
}

/// The pictures, of which each is in the page once: other places refer to it by its number.
class Pictures {
  public:
    explicit Pictures(const std::vector<Moment>& moments) : moments_(moments), is_shown_(moments.size()) {}

    /// The one nearest to a time; none where there is no picture at all.
    std::string nearest_to(double t_s) {
        std::size_t nearest = moments_.size();
        const auto apart = [&](std::size_t i) { return std::abs(moments_[i].t_s - t_s); };
        for (std::size_t i = 0; i < moments_.size(); ++i)
            if (!moments_[i].png.empty() && (nearest == moments_.size() || apart(i) < apart(nearest))) nearest = i;
        return nearest < moments_.size() ? figure(nearest) : "";
    }

    /// All of them, folded.
    std::string all() {
        if (moments_.empty()) return "";
        std::string out = "<div class=\"moments\">\n";
        for (std::size_t i = 0; i < moments_.size(); ++i) out += figure(i);
        return folded("Key moments", out + "</div>\n");
    }

  private:
    std::string figure(std::size_t i) {
        const Moment& moment = moments_[i];
        const bool again = is_shown_[i] && !moment.png.empty();
        is_shown_[i] = true;
        std::string image;
        if (!again && !moment.png.empty())
            image = "<img alt=\"" + escaped(moment.caption) + "\" src=\"data:image/png;base64," + base64(moment.png) +
                    "\">";
        return "<figure>" + image + "<figcaption><strong>" + std::to_string(i + 1) + "</strong> · " +
               number(moment.t_s, 2) + " s · " + escaped(moment.caption) + (again ? " (picture above)" : "") +
               "</figcaption></figure>\n";
    }

    const std::vector<Moment>& moments_;
    std::vector<bool> is_shown_;
};

// An item that was missed, with its picture.
std::string missed(const ScoreItem& item, Pictures& pictures) {
    const std::string by = scenarios::drill::missed_by(item);
    return "<section class=\"missed\"><div><h3>✗ " + escaped(item.title) + "</h3>\n<p><strong>" +
           escaped(with_unit(item.value, item.unit)) + "</strong>, asked: " + escaped(with_unit(item.band, item.unit)) +
           (by.empty() ? "" : ": " + escaped(by)) + ". At " + number(item.at_s, 1) + " s.</p>\n<p>" +
           escaped(item.why) + "</p></div>\n" + pictures.nearest_to(item.at_s) + "</section>\n";
}

std::string what_to_work_on(const Result& result, const std::vector<Placed>& order, Pictures& pictures) {
    std::string out, close;
    for (const Placed& placed : order) {
        const ScoreItem& item = result.items[placed.item];
        if (placed.standing == Standing::missed) out += missed(item, pictures);
        if (placed.standing == Standing::close)
            close += (close.empty() ? "" : "; ") + escaped(item.title) + " " +
                     escaped(with_unit(item.value, item.unit)) + " (" + escaped(with_unit(item.band, item.unit)) + ")";
    }
    if (!close.empty()) out += "<p>Passed, and close to the edge: " + close + ".</p>\n";
    return out.empty() ? "" : "<h2>What to work on</h2>\n" + out;
}

std::string timeline(const Result& result, const std::vector<Moment>& moments) {
    std::vector<double> times;
    for (const Moment& moment : moments) times.push_back(moment.t_s);
    const std::string svg = timeline_svg(result, times);
    const std::string numbered = moments.empty() ? "" : " Numbered lines are the key moments.";
    return folded("Timeline", svg.empty() ? "<p>Nothing was sampled in this session.</p>\n"
                                          : "<div class=\"scroll\">" + svg +
                                                "</div>\n<p class=\"note\">The figure on a curve is its largest "
                                                "value, looked at every 10 ms; scores are of every tick. Knots "
                                                "carry their table names; 0_1 is no knot." +
                                                numbered + "</p>\n");
}

std::string figure(const std::string& title, const std::string& value, const std::string& meaning) {
    return "<tr><th scope=\"row\">" + escaped(title) + "</th>" + cell("", value) + cell("", meaning) + "</tr>\n";
}

std::string thread(const Result& result) {
    const auto percent = [](double part) { return number(100 * part, 3) + " %"; };
    const auto& [p50, p99, max] = result.tick_us;
    const std::string tick_times = number(p50, 1) + " / " + number(p99, 1) + " / " + number(max, 1) + " µs";
    return folded(
        "Thread and simulation",
        head({"Figure", "Value", "Meaning"}) +
            figure("Pass-throughs", std::to_string(result.pass_throughs),
                   "Times the thread went through itself, a tool or a vessel, as audited.") +
            figure("Stretch, largest", percent(result.stretch_max),
                   "Worst link at any moment, against its rest length.") +
            figure("Stretch, at the end", percent(result.stretch_settled), "Worst link after the last tick.") +
            figure("Separation, least",
                   result.separation_min < 1e300 ? number(result.separation_min, 4) + " diameters" : "never near",
                   "Between links that are not neighbours; 1 is touching.") +
            figure("Node step, largest", number(result.node_step_max_over_bound, 4) + " of its bound",
                   "No node may move further in a substep than 1.") +
            figure("Contacts, most", std::to_string(result.contacts_max), "At once.") +
            figure("Links", std::to_string(result.links), "") +
            figure("Ticks", std::to_string(result.ticks), "In " + std::to_string(result.substeps) + " substeps.") +
            figure("Tick time", tick_times,
                   "Median, 99th percentile and largest, processor time" +
                       (result.machine.empty() ? "." : ", on " + result.machine + ".")) +
            figure("State hash", result.state_hash, "Equal inputs end in this state on every machine.") + table_end);
}

}  // namespace

std::string report_html(const Result& result, const std::vector<Moment>& moments) {
    const std::vector<Placed> order = scenarios::drill::by_importance(result.items);
    Pictures pictures(moments);
    std::string body = verdict(result) + what_to_work_on(result, order, pictures);
    body += scores(result, order);
    body += pictures.all() + timeline(result, moments) + thread(result);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
           "'unsafe-inline'\">\n<title>" +
           escaped(result.drill_title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n" + body +
           "</body>\n</html>\n";
}

}  // namespace app::report
