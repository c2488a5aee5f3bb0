package org.selectiverenderer.validation.language;

import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks the parents of statements, and elements outside of the Scene. */
final class StatementPlacementCheck implements FileCheck {
  private static final Map<String, Set<String>> PARENTS =
      Map.ofEntries(
          Map.entry("head", Set.of("X3D")),
          Map.entry("Scene", Set.of("X3D")),
          Map.entry("component", Set.of("head")),
          Map.entry("unit", Set.of("head")),
          Map.entry("meta", Set.of("head")),
          Map.entry("connect", Set.of("IS")),
          Map.entry("ProtoInterface", Set.of("ProtoDeclare")),
          Map.entry("ProtoBody", Set.of("ProtoDeclare")),
          Map.entry("fieldValue", Set.of("ProtoInstance")));

  /** Elements that must not contain nodes. */
  private static final Set<String> NO_NODES =
      Set.of(
          "X3D",
          "head",
          "component",
          "unit",
          "meta",
          "ROUTE",
          "IMPORT",
          "EXPORT",
          "IS",
          "connect",
          "ProtoDeclare",
          "ProtoInterface",
          "ExternProtoDeclare");

  @Override
  public void check(FileContext file, FindingCollector findings) {
    int scenes = 0;
    for (DocumentElement element : file.document().elements()) {
      DocumentElement parent = element.parent().orElse(null);
      if (parent == null || !file.knows(element) || !file.knows(parent)) {
        continue;
      }
      scenes += element.name().equals("Scene") && parent.name().equals("X3D") ? 1 : 0;
      if (!fits(file, element, parent)) {
        findings.add(ContainmentRules.MISPLACED_STATEMENT, element, element.name(), parent.name());
      }
    }
    DocumentElement root = file.document().root().orElse(null);
    boolean whole = root != null && root.name().equals("X3D") && !file.document().broken();
    if (whole && scenes != 1) {
      SourceLocation location = root.location();
      findings.add(ContainmentRules.NO_SCENE, location, "X3D", scenes == 0 ? "none" : scenes);
    }
  }

  private static boolean fits(FileContext file, DocumentElement element, DocumentElement parent) {
    NodeType node = file.catalogue().find(element.name()).orElse(null);
    NodeType parentNode = file.catalogue().find(parent.name()).orElse(null);
    if (node != null) {
      return !NO_NODES.contains(parent.name());
    }
    Set<String> parents = PARENTS.get(element.name());
    if (parents != null) {
      return parents.contains(parent.name());
    }
    return switch (element.name()) {
      case "field" ->
          parent.name().equals("ProtoInterface")
              || parent.name().equals("ExternProtoDeclare")
              || parentNode != null && NameScopes.hasOwnFields(parentNode);
      case "IS" -> parentNode != null || parent.name().equals("ProtoInstance");
      // ROUTE, IMPORT, EXPORT and prototypes may be anywhere among nodes.
      default -> !NO_NODES.contains(parent.name());
    };
  }
}
