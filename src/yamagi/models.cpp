// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/models.h"

#include "common/error.h"
#include "common/log.h"
#include "yamagi/kept.h"

#include <algorithm>

namespace vigil::yamagi {

void Models::use(refresh::Renderer* renderer) {
    renderer_ = renderer;
    begin_level(false);
}

void Models::begin_level(bool loaded) {
    has_level_ = loaded && renderer_ != nullptr;
    ++level_;
    skins_.clear();
}

ModelObject* Models::find(std::string_view name) {
    std::string file(name);
    std::ranges::replace(file, '\\', '/');
    auto known = models_.find(file);
    if (known == models_.end()) {
        if (file.empty() || (!file.starts_with('*') && !files_.exists(file))) return nullptr;
        auto model = std::make_unique<ModelObject>();
        model->name = file;
        known = models_.emplace(file, std::move(model)).first;
    }
    handle_of(*known->second); // files are read now, not in the frame that shows it
    return known->second.get();
}

refresh::ModelHandle Models::handle_of(const ModelObject& model) {
    if (!has_level_) return -1;
    if (model.level == level_) return model.handle;
    ModelObject& found = *models_.find(model.name)->second;
    found.level = level_;
    found.handle = -1;
    if (found.name.ends_with(".bsp")) return -1; // the level itself
    try {
        found.handle = renderer_->register_model(found.name);
    } catch (const Error& error) {
        log_warning("{}", error.what());
    }
    return found.handle;
}

refresh::SkinHandle Models::skin_of(const PictureObject* skin) {
    if (skin == nullptr || !has_level_) return -1;
    const std::string& file = static_cast<const Picture*>(skin)->file;
    return kept(skins_, file, -1, [&] { return renderer_->register_skin(file); });
}

} // namespace vigil::yamagi
