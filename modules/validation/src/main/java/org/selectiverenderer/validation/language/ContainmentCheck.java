package org.selectiverenderer.validation.language;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Checks which nodes are children of which nodes and in which fields, and which are at the top of
 * the scene.
 */
final class ContainmentCheck implements NameScopeCheck {
  /** The node types that the top of a scene may contain (X3D 4.0, 4.3.2). */
  private static final Set<String> TOP = Set.of("X3DChildNode", "LayerSet", "X3DMetadataObject");

  @Override
  public void check(DocumentElement parent, NameScopes scopes, FindingCollector findings) {
    if (parent.name().equals("Scene")) {
      parent.children().forEach(child -> top(child, scopes, findings));
      return;
    }
    NodeType type = scopes.file().catalogue().find(parent.name()).orElse(null);
    if (type == null) {
      return;
    }
    Set<String> filled = new HashSet<>();
    boolean old =
        scopes
            .file()
            .document()
            .root()
            .flatMap(root -> root.text("version"))
            .orElse("")
            .startsWith("3.");
    for (DocumentElement child : parent.children()) {
      NodeType childType = scopes.isNode(child) ? scopes.type(child).orElse(null) : null;
      if (childType != null) {
        child(type, child, childType, filled, old, findings);
      }
    }
  }

  private static void top(DocumentElement child, NameScopes scopes, FindingCollector findings) {
    scopes
        .type(child)
        .filter(type -> TOP.stream().noneMatch(type::is))
        .ifPresent(type -> findings.add(ContainmentRules.TOP, child, type));
  }

  private static void child(
      NodeType parent,
      DocumentElement child,
      NodeType type,
      Set<String> filled,
      boolean old,
      FindingCollector findings) {
    @Nullable String asked = child.text("containerField").map(String::strip).orElse(null);
    Optional<FieldDefinition> wanted = ContainerFieldRules.wanted(parent, type, asked);
    List<FieldDefinition> fitting = ContainerFieldRules.fitting(parent, type);
    if (wanted.isEmpty() && fitting.isEmpty()) {
      findings.add(ContainmentRules.MISPLACED_NODE, child, type, parent);
      return;
    }
    FieldDefinition field =
        wanted.orElseGet(
            () ->
                fitting.stream()
                    .filter(found -> found.type().multiple() || !filled.contains(found.name()))
                    .findFirst()
                    .orElse(fitting.get(0)));
    if (wanted.isEmpty()) {
      String name = asked == null ? ContainerFieldRules.usual(parent, type) : asked;
      String suggestion = "; it is used as its " + field.name();
      findings.add(ContainmentRules.CONTAINER_FIELD, child, type, name, parent, suggestion);
    } else if (asked != null
        && ContainerFieldRules.renamed(parent, asked).isPresent()
        && (!old || parent.is("Switch") || parent.is("LOD"))) {
      findings.add(FieldRules.OLD_SPELLING, child, asked, field.name());
    }
    if (!filled.add(field.name()) && !field.type().multiple()) {
      findings.add(ContainmentRules.TWICE, child, field.name(), parent);
    }
  }
}
