package org.selectiverenderer.validation.language;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.Profile;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Checks that the profile and the components that a file declares include those that its nodes
 * need.
 */
final class ProfileCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    Profile profile =
        file.document()
            .root()
            .flatMap(root -> root.text("profile"))
            .flatMap(Profile::of)
            .orElse(null);
    if (profile == null) {
      return;
    }
    Map<String, Integer> declared = new HashMap<>();
    file.scene()
        .components()
        .forEach((name, level) -> declared.merge(Profile.component(name), level, Math::max));
    for (DocumentElement element : file.document().elements()) {
      NodeType type = file.catalogue().find(element.name()).orElse(null);
      if (type != null) {
        String component = type.component();
        int has = Math.max(profile.level(component), declared.getOrDefault(component, 0));
        if (has < type.level()) {
          findings.add(
              HeadRules.NEEDS_COMPONENT, element, type, component, type.level(), profile.name());
          declared.put(component, type.level());
        }
      }
    }
  }
}
