// The numbers that go with the pictures, for people and for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

enum class Verdict { none, agrees, differs };

struct Row {
    std::string figure; // "3a"
    std::string model;  // load model, or another name for the number's case
    std::string what;
    double value = 0.0;
    std::string unit;  // may be empty
    std::string paper; // the paper's value; may be empty
    Verdict verdict = Verdict::none;
};

class Numbers {
public:
    void show(std::string figure, std::string model, std::string what, double value, std::string unit,
              std::string paper = "");
    void judge(std::string figure, std::string model, std::string what, double value, std::string unit,
               std::string paper, bool agrees);

    const std::vector<Row>& rows() const { return rows_; }
    std::string markdown() const; // a table for each figure
    std::string json(std::uint64_t seed, std::uint32_t falls) const;

private:
    std::vector<Row> rows_;
};
