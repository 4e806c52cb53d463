#include "tests/bench/suites/stability.hpp"

#include <algorithm>
#include <set>

#include "tests/bench/lab/capstan.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/trace.hpp"
#include "tests/bench/suites/ties.hpp"

namespace bench::suites {

using namespace lab;

// The condition's name; numbered from the second on where a scene has it twice, of two times or two nodes.
static std::string id_of(const HardCase& hard_case, const Condition& condition, std::set<std::string>& taken) {
    std::string id = hard_case.id + '-' + condition.is + (condition.event.empty() ? "" : '-' + condition.event) +
                     (condition.model == "elastic" ? "-elastic" : "");
    std::replace(id.begin(), id.end(), '_', '-');
    std::string unique = id;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = id + '-' + std::to_string(i);
    return unique;
}

static Row row_of(const HardCase& hard_case, const Outcome& outcome, std::string id) {
    const ConditionKind& kind = condition_kind(outcome.condition.is);
    Row row{std::move(id),          kind.words, outcome.value,  kind.unit, outcome.condition.bound,
            outcome.condition.must, {},         outcome.seconds};
    row.what += ". If not: " + hard_case.goes_wrong;
    return row;
}

std::vector<Row> hard_case_rows(const std::filesystem::path& scenes, bool quick, const Progress& progress) {
    std::vector<Row> rows;
    std::set<std::string> taken;
    std::vector<HardCase> cases;  // all are read before the first is played: a broken file costs no time
    for (const auto& file : hard_case_files(scenes)) cases.push_back(load_hard_case(file));
    for (const HardCase& hard_case : cases) {
        if (progress) progress(hard_case.id);
        for (const Outcome& outcome : examine(hard_case, quick))
            rows.push_back(row_of(hard_case, outcome, id_of(hard_case, outcome.condition, taken)));
    }
    return rows;
}

struct Law {
    const char* name;
    std::vector<Row> (*measure)(bool quick);
};

static constexpr Law laws[] = {
    {"tight knots", tight_rows}, {"stick and slip", stick_rows}, {"rest", rest_rows}, {"invariance", invariance_rows},
    {"memory", memory_rows},     {"capstan", capstan_rows},      {"ties", ties_rows}};

Suite stability_suite(const std::filesystem::path& scenes, bool quick, const Progress& progress) {
    Suite suite{"stability", hard_case_rows(scenes, quick, progress)};
    for (const Law& law : laws) {
        if (progress) progress(law.name);
        for (Row& row : law.measure(quick)) suite.rows.push_back(std::move(row));
    }
    return suite;
}

}  // namespace bench::suites
