#include "document.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "figure.hpp"
#include "growth.hpp"
#include "markdown.hpp"
#include "names.hpp"
#include "plot_data.hpp"

namespace report {
namespace {

using Lines = std::vector<std::string>;

// "%table rows": its first word, and the rest.
bool is(const std::string &line, const std::string &word) {
  return line.starts_with('%' + word) && (line.size() == word.size() + 1 || line[word.size() + 1] == ' ');
}
std::string rest_of(const std::string &line) {
  const size_t blank = line.find(' ');
  return blank == std::string::npos ? "" : line.substr(blank + 1);
}
bool opens(const std::string &line) {
  constexpr const char *blocks[] = {"list", "each", "if", "table", "goals", "data"};
  return std::any_of(std::begin(blocks), std::end(blocks), [&](const char *word) { return is(line, word); });
}

constexpr double busy = 1.5;  // a benchmark itself is a load of 1

// Whether anything else was running, as far as the load average tells.
std::string describe_load(const Run &run) {
  if (run.loads.empty()) return "unknown";
  const auto [least, most] = std::minmax_element(run.loads.begin(), run.loads.end());
  std::string text =
      fixed(*least, 2) + " to " + fixed(*most, 2) + " when the programs began, of which up to 1 is the benchmarks' own";
  if (*most > busy) text += ". **The machine was busy: do not quote these times**";
  return text;
}

struct Column {
  std::string head, cell;
  bool fitted;
};

// A row: what names stand for in its cells, and its benchmark.
struct Row {
  Names names;
  std::string benchmark;
};

class Document {
 public:
  // Without `out` only the tables for plots are written.
  Document(const Results &results, std::ostream *out) : results_(results), run_(results.run), out_(out) {}

  void write(const Lines &lines) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const std::string line = with_names(lines[i], names_);
      try {
        if (!opens(line)) {
          write_line(line);
          continue;
        }
        const size_t begin = i + 1;
        for (int depth = 1; depth > 0;) {
          if (++i == lines.size()) throw std::runtime_error("no %end");
          depth += opens(lines[i]) ? 1 : is(lines[i], "end") ? -1 : 0;
        }
        write_block(
            line, {lines.begin() + static_cast<std::ptrdiff_t>(begin), lines.begin() + static_cast<std::ptrdiff_t>(i)});
      } catch (const std::exception &error) {
        throw std::runtime_error(line + "\n  " + error.what());
      }
    }
  }

 private:
  void write_line(const std::string &line) {
    const std::string rest = rest_of(line);
    if (is(line, "set")) {
      const size_t blank = rest.find(' ');
      if (blank == std::string::npos) throw std::runtime_error("no name, or nothing that it stands for");
      names_[rest.substr(0, blank)] = rest.substr(blank + 1);
    } else if (out_ == nullptr) {
      return;
    } else if (is(line, "facts")) {
      for (const auto &[key, value] : run_.context) {
        if (key.starts_with(rest)) *out_ << "- " << key.substr(rest.size()) << ' ' << value << '\n';
      }
    } else if (is(line, "failed")) {
      const std::string prefix = rest.substr(0, rest.find('*'));
      for (const std::string &name : run_.order) {
        if (!name.starts_with(prefix)) continue;
        *out_ << "- " << name.substr(prefix.size()) << ": " << run_.benchmarks.at(name).error << '\n';
      }
    } else if (is(line, "plot")) {
      const std::string file = "plots/" + rest.substr(0, rest.find(' ')) + ".svg";
      if (!std::filesystem::exists(results_.folder / file)) return;
      *out_ << "![" << rest.substr(rest.find(' ') + 1) << "](" << file << ")\n\n";
    } else if (line.starts_with('%')) {
      throw std::runtime_error("no such instruction");
    } else {
      *out_ << filled(line, {run_, lists_}, false) << '\n';
    }
  }

  void write_block(const std::string &line, const Lines &lines) {
    if (is(line, "list")) {
      read_list(rest_of(line), lines);
    } else if (is(line, "each")) {
      write(repeated(rest_of(line), lines));
    } else if (is(line, "if")) {
      write(chosen(rest_of(line), lines));
    } else if (is(line, "data")) {
      const std::string file = rest_of(line) + ".dat";
      if (out_ == nullptr) write_plot_table(results_.folder / "plots" / file, flat(lines), run_, lists_);
    } else if (out_ == nullptr) {
      return;
    } else if (is(line, "table")) {
      write_table(rest_of(line), flat(lines));
    } else {
      write_goals(*out_, flat(lines), run_, results_.turns, lists_);
    }
  }

  // Without %each.
  Lines flat(const Lines &lines) const {
    Lines found;
    for (size_t i = 0; i < lines.size(); ++i) {
      if (!is(lines[i], "each")) {
        found.push_back(with_names(lines[i], names_));
        continue;
      }
      const auto first = lines.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      const auto end = std::find(first, lines.end(), "%end");
      for (const std::string &line : repeated(rest_of(lines[i]), {first, end}))
        found.push_back(with_names(line, names_));
      i = static_cast<size_t>(end - lines.begin());
    }
    return found;
  }

  const List &list(const std::string &name) const {
    const auto found = lists_.find(name);
    if (found == lists_.end()) throw std::runtime_error("no list " + name);
    return found->second;
  }

  void read_list(const std::string &name, const Lines &lines) {
    List made;
    const std::vector<std::string> heads = split(lines.at(0), "|");
    for (size_t i = 1; i < lines.size(); ++i) {
      const std::vector<std::string> texts = split(with_names(lines[i], names_), "|");
      if (texts.size() != heads.size())
        throw std::runtime_error(lines[i] + "\n  has not as many parts as the first line");
      Names row;
      for (size_t k = 0; k < heads.size(); ++k) row[heads[k]] = texts[k];
      made.rows.push_back(row);
    }
    lists_[name] = made;
  }

  Lines repeated(const std::string &name, const Lines &lines) const {
    Lines found;
    for (const Names &row : list(name).rows) {
      for (const std::string &line : lines) found.push_back(with_names(line, row));
    }
    return found;
  }

  Lines chosen(const std::string &figure, const Lines &lines) const {
    const bool holds = figure == "turns" ? results_.turns != nullptr : !std::isnan(amount(figure, {run_, lists_}));
    size_t middle = 0;
    for (int depth = 0; middle < lines.size() && !(depth == 0 && is(lines[middle], "else")); ++middle) {
      depth += opens(lines[middle]) ? 1 : is(lines[middle], "end") ? -1 : 0;
    }
    const auto split_at = lines.begin() + static_cast<std::ptrdiff_t>(middle);
    if (holds) return {lines.begin(), split_at};
    return split_at == lines.end() ? Lines() : Lines(split_at + 1, lines.end());
  }

  // The text with its figures. In a cell a figure that is missing leaves nothing but a dash.
  std::string filled(const std::string &text, const Scope &scope, bool cell) const {
    std::string made;
    size_t at = 0;
    for (size_t open = text.find('{'); open != std::string::npos; open = text.find('{', at)) {
      const size_t close = text.find('}', open);
      if (close == std::string::npos) throw std::runtime_error("a brace does not close");
      const std::string figure = text.substr(open + 1, close - open - 1);
      std::string value;
      if (figure == "load") {
        value = describe_load(run_);
      } else if (figure.starts_with("= ")) {
        const auto found = run_.context.find(figure.substr(2));
        value = found == run_.context.end() ? "unknown" : found->second;
      } else {
        value = written(figure, scope);
      }
      if (cell && value == "-") return value;
      made += text.substr(at, open - at) + value;
      at = close + 1;
    }
    return made + text.substr(at);
  }

  void write_table(const std::string &head, const Lines &lines) const {
    std::vector<Column> columns;
    std::vector<std::string> heads;
    for (const std::string &line : lines) {
      const std::vector<std::string> parts = split(line, " | ");
      if (parts.size() < 2) throw std::runtime_error(line + "\n  is no column");
      columns.push_back({parts[0], parts[1], parts.size() > 2});
      heads.push_back(parts[0]);
    }
    const std::vector<std::string> options = split(head, ",");
    double from = 0;
    std::vector<std::string> fitted;
    for (size_t i = 1; i < options.size(); ++i) {
      const std::vector<std::string> words = split(options[i], " ");
      if (words.at(0) == "from") from = std::stod(words.at(1));
      if (words.at(0) == "fitted") fitted.assign(words.begin() + 1, words.end());
    }
    std::vector<Row> rows;
    for (const std::string &nested : split(options[0], ";"))
      collect_rows(rows, split(nested, " "), 0, {names_, ""}, from);
    Table table(heads);
    for (const Row &row : rows) table.row(cells_of(row, columns));
    for (const std::string &least : fitted) table.row(fit(rows, columns, std::stod(least)));
    table.write(*out_);
  }

  // Rows for the sources from the k-th on.
  void collect_rows(std::vector<Row> &rows, const std::vector<std::string> &sources, size_t k, const Row &row,
                    double from) const {
    if (k == sources.size()) {
      rows.push_back(row);
      return;
    }
    const std::string source = with_names(sources[k], row.names);
    const auto add = [&](const Names &names, const std::string &benchmark) {
      Row next{names, benchmark};
      next.names.insert(row.names.begin(), row.names.end());
      collect_rows(rows, sources, k + 1, next, from);
    };
    if (!source.ends_with('*')) {
      for (const Names &names : list(source).rows) add(names, row.benchmark);
      return;
    }
    const std::string prefix = source.substr(0, source.size() - 1);
    for (const std::string &molecule : molecules_by_size(run_, prefix)) {
      const Measurement *m = run_.find(prefix + molecule);
      if (m == nullptr || m->counter("atoms") >= from) add({{"molecule", molecule}}, prefix + molecule);
    }
  }

  std::vector<std::string> cells_of(const Row &row, const std::vector<Column> &columns) const {
    std::vector<std::string> cells;
    const bool failed = !row.benchmark.empty() && run_.find(row.benchmark) == nullptr;
    for (const Column &column : columns) {
      const std::string cell = with_names(column.cell, row.names);
      if (failed && cells.size() == 1) {
        cells.push_back(run_.benchmarks.at(row.benchmark).error);
      } else if (failed && cells.size() > 1) {
        cells.emplace_back("-");
      } else {
        cells.push_back(filled(cell, {run_, lists_, row.benchmark}, true));
      }
    }
    return cells;
  }

  // Exponents of the fitted columns, of what stands in their braces before the colon.
  std::vector<std::string> fit(const std::vector<Row> &rows, const std::vector<Column> &columns, double from) const {
    std::vector<std::string> cells{"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all"};
    for (size_t k = 2; k < columns.size(); ++k) {
      if (!columns[k].fitted) {
        cells.emplace_back();
        continue;
      }
      std::vector<std::pair<double, double>> amounts;
      for (const Row &row : rows) {
        const Measurement *m = run_.find(row.benchmark);
        if (m == nullptr || m->counter("atoms") < from) continue;
        const std::string cell = with_names(columns[k].cell, row.names);
        const double value = plain_amount(cell.substr(1, cell.find('}') - 1), {run_, lists_, row.benchmark});
        if (!std::isnan(value)) amounts.emplace_back(m->counter("atoms"), value);
      }
      const double exponent = growth_exponent(amounts);
      cells.push_back(std::isnan(exponent) ? "-" : fixed(exponent, 3));
    }
    return cells;
  }

  const Results &results_;
  const Run &run_;
  std::ostream *out_;
  Names names_;
  Lists lists_;
};

}  // namespace

void write_document(std::ostream &out, const std::vector<std::string> &source, const Results &results) {
  Document(results, &out).write(source);
}

void write_plot_data(const std::vector<std::string> &source, const Results &results) {
  Document(results, nullptr).write(source);
}

}  // namespace report
