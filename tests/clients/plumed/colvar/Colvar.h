// Our own declarations of the names of PLUMED that capi/clients/plumed uses, so that a test can compile and run it
// without PLUMED. As strict: words and components have to be registered, and every word of a line has to be read.
#ifndef COLVAR_COLVAR_H
#define COLVAR_COLVAR_H

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace PLMD {

class AtomNumber {
 public:
  static AtomNumber serial(unsigned number) {
    AtomNumber atom;
    atom.serial_ = number;
    return atom;
  }
  unsigned serial() const { return serial_; }

 private:
  unsigned serial_ = 0;
};

class Vector {
 public:
  Vector() = default;
  Vector(double x, double y, double z) : at_{x, y, z} {}
  double &operator[](unsigned k) { return at_.at(k); }
  const double &operator[](unsigned k) const { return at_.at(k); }

 private:
  std::array<double, 3> at_{};
};

class Tensor {
 public:
  Vector &operator[](unsigned k) { return row_.at(k); }
  const Vector &operator[](unsigned k) const { return row_.at(k); }

 private:
  std::array<Vector, 3> row_{};
};

class Value {
 public:
  void set(double value) { value_ = value; }
  double get() const { return value_; }

  bool not_periodic = false;
  std::vector<Vector> by_atom;
  Tensor virial;

 private:
  double value_ = std::nan("");
};

class Units {
 public:
  const double &getLength() const { return length; }
  double length = 1;  // in nm
};

class Log {
 public:
  int printf(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char line[1000];
    const int written = std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text += line;
    return written;
  }
  std::string text;
};

class Keywords {
 public:
  void add(const std::string &kind, const std::string &key, const std::string &about) { take(kind, key, about); }
  void add(const std::string &kind, const std::string &key, const std::string &value, const std::string &about) {
    take(kind, key, about);
    values[key] = value;
  }
  void addFlag(const std::string &key, bool, const std::string &about) { take("flag", key, about); }
  void addOutputComponent(const std::string &name, const std::string &, const std::string &type,
                          const std::string &about) {
    if (type != "scalar" || about.empty()) throw std::logic_error(name);
    components.insert(name);
  }
  bool has_component(const std::string &name) const { return components.count(name.substr(0, name.find('-'))) != 0; }

  std::map<std::string, std::string> kinds, values;
  std::set<std::string> components;

 private:
  void take(const std::string &kind, const std::string &key, const std::string &about) {
    if (about.empty() || !kinds.emplace(key, kind).second) throw std::logic_error(key);
  }
};

struct ActionOptions {
  std::map<std::string, std::string> words;  // a flag's value is empty
  Keywords keys;
  double length = 1;
};

class Colvar {
 public:
  explicit Colvar(const ActionOptions &options) : words_(options.words), keys_(options.keys) {
    units_.length = options.length;
  }
  virtual ~Colvar() = default;
  virtual void calculate() = 0;
  static void registerKeywords(Keywords &keys) { keys.addFlag("NOPBC", false, "no periodic boundaries"); }

  // The test's side.
  std::vector<AtomNumber> requested;
  std::vector<Vector> position;  // of those
  Tensor box;
  std::map<std::string, std::unique_ptr<Value>> computed;
  Log log;

 protected:
  [[noreturn]] void error(const std::string &text) const { throw std::runtime_error(text); }
  void parseAtomList(const std::string &key, std::vector<AtomNumber> &atoms) { list(key, key, atoms); }
  void parseAtomList(const std::string &key, int number, std::vector<AtomNumber> &atoms) {
    list(key, key + std::to_string(number), atoms);
  }
  template <class Type>
  void parse(const std::string &key, Type &value) {
    std::string word;
    if (!take(key, key, word) && keys_.values.count(key) != 0) word = keys_.values.at(key);
    if (word.empty()) return;
    std::istringstream stream(word);
    if (!(stream >> value) || !stream.eof()) error("could not understand " + key + "=" + word);
  }
  void parseVector(const std::string &key, std::vector<double> &values) {
    std::string word, part;
    values.clear();
    take(key, key, word);
    for (std::istringstream stream(word); std::getline(stream, part, ',');) values.push_back(std::stod(part));
  }
  void parseFlag(const std::string &key, bool &value) {
    std::string word;
    value = take(key, key, word);
  }
  void checkRead() const {
    if (!words_.empty()) error("cannot understand the following words: " + words_.begin()->first);
  }
  void addComponentWithDerivatives(const std::string &name) {
    if (!keys_.has_component(name)) throw std::logic_error(name + " has not been registered");
    if (!computed.emplace(name, std::make_unique<Value>()).second) throw std::logic_error(name + " is there already");
  }
  void componentIsNotPeriodic(const std::string &name) { computed.at(name)->not_periodic = true; }
  void requestAtoms(const std::vector<AtomNumber> &atoms) {
    requested = atoms;
    for (auto &[name, value] : computed) value->by_atom.resize(atoms.size());
  }
  unsigned getNumberOfAtoms() const { return static_cast<unsigned>(requested.size()); }
  AtomNumber getAbsoluteIndex(int i) const { return requested.at(static_cast<size_t>(i)); }
  const Vector &getPosition(int i) const { return position.at(static_cast<size_t>(i)); }
  const Tensor &getBox() const { return box; }
  const Units &getUnits() const { return units_; }
  Value *getPntrToComponent(const std::string &name) { return computed.at(name).get(); }
  void setAtomsDerivatives(Value *value, int i, const Vector &d) { value->by_atom.at(static_cast<size_t>(i)) = d; }
  void setBoxDerivatives(Value *value, const Tensor &d) { value->virial = d; }
  void setBoxDerivativesNoPbc(Value *value) {
    value->virial = Tensor();
    for (size_t i = 0; i < position.size(); ++i) {
      for (unsigned k = 0; k < 9; ++k) value->virial[k / 3][k % 3] -= position[i][k / 3] * value->by_atom[i][k % 3];
    }
  }
  // Each atom becomes that image of it which is nearest to the one before.
  void makeWhole() {
    for (size_t i = 1; i < position.size(); ++i) {
      Vector nearest = position[i];
      double least = HUGE_VAL;
      for (int shift = 0; shift < 343; ++shift) {
        Vector at = position[i];
        double distance = 0;
        for (unsigned k = 0; k < 3; ++k) {
          at[k] += (shift % 7 - 3) * box[0][k] + (shift / 7 % 7 - 3) * box[1][k] + (shift / 49 - 3) * box[2][k];
          distance += (at[k] - position[i - 1][k]) * (at[k] - position[i - 1][k]);
        }
        if (distance < least) least = distance, nearest = at;
      }
      position[i] = nearest;
    }
  }

 private:
  bool take(const std::string &key, const std::string &as, std::string &word) {
    if (keys_.kinds.count(key) == 0) throw std::logic_error(key + " has not been registered");
    const auto found = words_.find(as);
    if (found == words_.end()) return false;
    word = found->second;
    words_.erase(found);
    return true;
  }
  // 3,5-8,20
  void list(const std::string &key, const std::string &as, std::vector<AtomNumber> &atoms) {
    std::string word, part;
    atoms.clear();
    take(key, as, word);
    for (std::istringstream stream(word); std::getline(stream, part, ',');) {
      const size_t dash = part.find('-');
      const auto first = static_cast<unsigned>(std::stoul(part));
      const auto last = dash == std::string::npos ? first : static_cast<unsigned>(std::stoul(part.substr(dash + 1)));
      for (unsigned k = first; k <= last; ++k) atoms.push_back(AtomNumber::serial(k));
    }
  }

  std::map<std::string, std::string> words_;
  Keywords keys_;
  Units units_;
};

#define PLUMED_COLVAR_INIT(options) Colvar(options)

struct registered {
  struct action {
    void (*register_keywords)(Keywords &);
    std::function<std::unique_ptr<Colvar>(const ActionOptions &)> make;
  };
  bool add(const std::string &directive, void (*keywords)(Keywords &),
           const std::function<std::unique_ptr<Colvar>(const ActionOptions &)> &make) {
    return actions.emplace(directive, action{keywords, make}).second;
  }
  std::map<std::string, action> actions;
};

inline registered &registered_actions() {
  static registered all;
  return all;
}

namespace colvar {
using PLMD::Colvar;
}

}  // namespace PLMD

#endif
