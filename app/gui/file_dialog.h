#pragma once
// Choosing a file to open or to save.

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/widgets.h"

namespace eyeray {

/// A browser of folders; shows folders and the files of the given endings.
class FileDialog {
public:
    enum class Purpose : std::uint8_t { Open, Save };

    /// Starts in `folder`, or the working folder if that is none.
    void begin(Purpose, const std::filesystem::path& folder, std::vector<std::string> endings,
               std::string name = {});

    /// Draws the dialog's content in the current window. A file once one is chosen.
    std::optional<std::filesystem::path> draw(const Widgets&);

private:
    struct Entry {
        std::string name;
        bool folder;
    };
    void enter(const std::filesystem::path& folder);

    Purpose purpose_ = Purpose::Open;
    std::filesystem::path folder_;
    std::vector<std::string> endings_;
    std::vector<Entry> entries_;
    std::string name_; // typed or clicked
    std::string problem_;
};

}
