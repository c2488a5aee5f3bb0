package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.Profile;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks the attributes of the root element and the statements of the head. */
final class HeadCheck implements FileCheck {
  static final List<String> VERSIONS = List.of("3.0", "3.1", "3.2", "3.3", "4.0", "4.1");
  private static final List<String> HEAD_ORDER = List.of("component", "unit", "meta");
  private static final List<String> UNITS = List.of("angle", "force", "length", "mass");

  @Override
  public void check(FileContext file, FindingCollector findings) {
    DocumentElement root = file.document().root().orElse(null);
    if (root == null || !root.name().equals("X3D")) {
      return;
    }
    version(root, findings);
    profile(root, findings);
    boolean scene = false;
    for (DocumentElement child : root.children()) {
      scene |= child.name().equals("Scene");
      if (child.name().equals("head")) {
        if (scene) {
          findings.add(HeadRules.ORDER, child, "head", "after the Scene");
        }
        head(file, child, findings);
      }
    }
  }

  private static void version(DocumentElement root, FindingCollector findings) {
    DocumentAttribute version = root.attribute("version").orElse(null);
    if (version == null && !StatementAttributes.lacks(root, "version")) {
      return;
    }
    if (version == null) {
      findings.add(HeadRules.VERSION, root, "X3D needs a version, such as 4.0");
    } else if (!VERSIONS.contains(version.text().strip())) {
      findings.add(
          HeadRules.VERSION, version, "there is no version '" + version.text() + "' of X3D");
    }
  }

  private static void profile(DocumentElement root, FindingCollector findings) {
    DocumentAttribute profile = root.attribute("profile").orElse(null);
    if (profile == null && !StatementAttributes.lacks(root, "profile")) {
      return;
    }
    if (profile == null) {
      findings.add(HeadRules.PROFILE, root, "X3D needs a profile, such as Immersive");
    } else if (Profile.of(profile.text()).isEmpty()) {
      findings.add(
          HeadRules.PROFILE,
          profile,
          "there is no profile '"
              + profile.text()
              + "'"
              + SpellingSuggestion.of(profile.text(), Profile.names()));
    }
  }

  private static void head(FileContext file, DocumentElement head, FindingCollector findings) {
    int reached = 0;
    for (DocumentElement child : head.children()) {
      int place = HEAD_ORDER.indexOf(child.name());
      if (place >= 0 && place < reached) {
        String after = HEAD_ORDER.get(reached);
        findings.add(HeadRules.ORDER, child, child.name(), "after " + after);
      }
      reached = Math.max(reached, place);
      switch (child.name()) {
        case "component" -> component(file, child, findings);
        case "unit" -> unit(child, findings);
        case "meta" -> needs(child, findings, "content");
        default -> {
          // {@link StatementPlacementCheck} reports other elements.
        }
      }
    }
  }

  private static void component(
      FileContext file, DocumentElement element, FindingCollector findings) {
    if (!needs(element, findings, "name", "level")) {
      return;
    }
    Set<String> known = new TreeSet<>(Profile.COMPONENTS_WITHOUT_NODES);
    file.catalogue().all().stream().map(NodeType::component).forEach(known::add);
    DocumentAttribute name = element.attribute("name").orElseThrow();
    if (!known.contains(Profile.component(name.text().strip()))) {
      findings.add(
          HeadRules.COMPONENT,
          name,
          "there is no component '"
              + name.text()
              + "'"
              + SpellingSuggestion.of(name.text(), known));
    }
    DocumentAttribute level = element.attribute("level").orElse(null);
    if (level != null && !level.text().strip().matches("[1-5]")) {
      findings.add(
          HeadRules.COMPONENT,
          level,
          "a level must be a whole number from 1 to 5, not '" + level.text() + "'");
    }
  }

  private static void unit(DocumentElement element, FindingCollector findings) {
    if (needs(element, findings, "category", "name", "conversionFactor")) {
      DocumentAttribute factor = element.attribute("conversionFactor").orElseThrow();
      FieldCheck.value(factor, FieldType.SFDouble, findings);
      DocumentAttribute category = element.attribute("category").orElseThrow();
      if (!UNITS.contains(category.text().strip())) {
        findings.add(
            HeadRules.INCOMPLETE,
            category,
            "unit",
            "a category: " + String.join(", ", UNITS) + ", not '" + category.text() + "'");
      }
    }
  }

  private static boolean needs(
      DocumentElement element, FindingCollector findings, String... attributes) {
    for (String attribute : attributes) {
      if (element.attribute(attribute).isEmpty()) {
        if (StatementAttributes.lacks(element, attribute)) {
          findings.add(HeadRules.INCOMPLETE, element, element.name(), attribute);
        }
        return false;
      }
    }
    return true;
  }
}
