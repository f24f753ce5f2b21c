#include <fmt/format.h>

#include "app/gui/ledger_parts.h"
#include "app/gui/theme.h"
#include "core/study/palette.h"
#include "core/study/path_sum.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr int kColumns = 7;

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void colorCell(const Widgets& ui, const Color& value) {
    ImGui::TableNextColumn();
    swatch(ui, value);
    ImGui::SameLine();
    ImGui::TextUnformatted(colorText(value).c_str());
}

int rayOf(const SampleRecord& record, const PathTerm& term) {
    return term.lamp >= 0 ? record.lamps[static_cast<std::size_t>(term.lamp)].shadowRay : term.ray;
}

void row(const Widgets& ui, const Scene& scene, const SampleRecord& record, const PathTerm& term, int index) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const int ray = rayOf(record, term);
    const RayKind kind =
        term.lamp >= 0 ? RayKind::Shadow : record.rays[static_cast<std::size_t>(term.ray)].kind;
    ImGui::PushID(index);
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(kind, ui.dark));
    if (ImGui::Selectable(wayOf(scene, record, term).c_str(), ray >= 0 && ray == ui.viewer.selectedRay(),
                          ImGuiSelectableFlags_SpanAllColumns))
        ui.execute({"select-ray", {{"index", fmt::format("{}", std::max(ray, 0))}}}, {});
    ImGui::PopStyleColor();
    ui.mark(fmt::format("path term {}", index));
    ImGui::PopID();
    cell(amountText(term.throughput));
    cell(term.lamp >= 0 ? amountText(term.scattered) : "");
    cell(term.pdfW > 0 ? fmt::format("{:.3g}", term.pdfW) : "");
    cell(fmt::format("{:.3g}", term.mis));
    cell(amountText(term.radiance * term.visibility));
    colorCell(ui, term.value);
}

void result(const Widgets& ui, const std::string& what, const Color& value) {
    ImGui::TableNextRow();
    cell(what);
    ImGui::TableSetColumnIndex(kColumns - 2);
    colorCell(ui, value);
}

}

void pathSum(const Widgets& ui) {
    constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_Resizable |
                            ImGuiTableFlags_SizingStretchProp;
    constexpr std::array<const char*, kColumns> kTitles = {"light of",   "throughput", "f cos", "/ pdf",
                                                           "MIS weight", "radiance",   "gives"};
    constexpr std::array<float, kColumns> kWidths = {11, 7, 7, 3, 4.5F, 7, 10};
    if (!ImGui::BeginTable("path sum", kColumns, kFlags)) return;
    for (std::size_t i = 0; i < kColumns; ++i) ImGui::TableSetupColumn(kTitles[i], 0, kWidths[i]);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableHeadersRow();
    const SampleRecord& record = ui.viewer.picked()->trace;
    const std::shared_ptr<const Scene> scene = ui.viewer.document().scene;
    const std::vector<PathTerm> terms = pathTermsOf(record);
    result(ui, fmt::format("sum of {} ways", terms.size()), Color(sumOf(terms)));
    result(ui, fmt::format("sample {} in the film", ui.viewer.picked()->sample),
           ui.viewer.picked()->trace.radiance);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        row(ui, *scene, record, terms[i], static_cast<int>(i));
        if (!ui.viewer.picked()) break;
    }
    ImGui::EndTable();
}

}
