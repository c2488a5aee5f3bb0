package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * Compares two states of a scene's text and returns a patch if a running scene can be updated
 * without loading it again. That is so where the elements are the same and only fields differ that
 * may change at any time (accessType inputOutput, X3D 4.0 4.4.2.2), or metadata. Changes of
 * prototypes, scripts, names and whatever names a file need loading.
 */
final class SceneTextDiff {
  /** Most characters of a text that is compared; beyond it comparing costs too much memory. */
  private static final int MOST = 8_000_000;

  /** Fields that name files, which bring other nodes. */
  private static final Set<String> NAMING = Set.of("url", "load", "autoRefresh");

  /** Meaningful attributes of the XML encoding that are no fields. */
  private static final Set<String> OF_ENCODING = Set.of("DEF", "USE", "containerField");

  private final NodeCatalogue catalogue;
  private final String before;
  private final String after;
  private final ElementTree oldTree;
  private final ElementTree tree;
  private final List<ScenePatch.Field> fields = new ArrayList<>();
  private final List<ScenePatch.Metadata> metadata = new ArrayList<>();
  private final Map<Place, Place> moved = new HashMap<>();

  private SceneTextDiff(NodeCatalogue catalogue, DocumentSnapshot before, DocumentSnapshot after)
      throws XmlParseException {
    this.catalogue = catalogue;
    this.before = before.text();
    this.after = after.text();
    oldTree = before.elements();
    tree = after.elements();
  }

  /**
   * Compares two snapshots.
   *
   * @return empty where the scene has to be loaded again
   */
  static Optional<ScenePatch> between(
      DocumentSnapshot before, DocumentSnapshot after, NodeCatalogue catalogue) {
    if (Math.max(before.text().length(), after.text().length()) > MOST) {
      return Optional.empty();
    }
    try {
      SceneTextDiff comparison = new SceneTextDiff(catalogue, before, after);
      boolean same = comparison.same(comparison.oldTree.root(), comparison.tree.root());
      return same
          ? Optional.of(
              new ScenePatch(
                  before.revision(),
                  after.revision(),
                  comparison.fields,
                  comparison.metadata,
                  comparison.moved))
          : Optional.empty();
    } catch (XmlParseException e) {
      return Optional.empty(); // Loading the text reports the fault.
    }
  }

  private boolean same(DocumentElement old, DocumentElement now) {
    if (!old.name().equals(now.name())) {
      return false;
    }
    Optional<NodeType> type = catalogue.find(old.name());
    if (type.isEmpty() && !old.name().equals("Scene") && !old.name().equals("X3D")
        || type.filter(SceneTextDiff::holdsCode).isPresent()) {
      return before.regionMatches(old.start(), after, now.start(), old.end() - old.start())
          && placed(old, now);
    }
    if (!sameTag(old, now, type)) {
      return false;
    }
    place(old, now);
    List<DocumentElement> oldChildren = withoutMetadata(old);
    List<DocumentElement> children = withoutMetadata(now);
    if (oldChildren.size() != children.size()
        || children.isEmpty() && !inner(before, old).equals(inner(after, now))
        || type.isPresent() && !sameMetadata(old, now)) {
      return false;
    }
    for (int i = 0; i < children.size(); i++) {
      if (!same(oldChildren.get(i), children.get(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean holdsCode(NodeType type) {
    return type.is("X3DScriptNode") || type.is("X3DShaderNode") || type.name().startsWith("Shader");
  }

  /** Returns the text content of an element without children, such as a CDATA section. */
  private static String inner(String text, DocumentElement element) {
    return element.open() && element.children().isEmpty()
        ? text.substring(element.tagEnd(), element.end()).replaceFirst("</[^<]*$", "").strip()
        : "";
  }

  private boolean sameTag(DocumentElement old, DocumentElement now, Optional<NodeType> type) {
    int length = old.tagEnd() - old.start();
    if (length == now.tagEnd() - now.start()
        && before.regionMatches(old.start(), after, now.start(), length)) {
      return true;
    }
    Map<String, DocumentAttribute> values = attributes(now);
    Map<String, DocumentAttribute> names = attributes(old);
    names.putAll(values);
    for (String name : names.keySet()) {
      Optional<String> was = old.text(name);
      Optional<String> is = now.text(name);
      if (!was.equals(is) && !takes(old, type, name, Optional.ofNullable(values.get(name)))) {
        return false;
      }
    }
    return true;
  }

  private static Map<String, DocumentAttribute> attributes(DocumentElement element) {
    Map<String, DocumentAttribute> attributes = new LinkedHashMap<>();
    element.attributes().forEach(each -> attributes.put(each.name(), each));
    return attributes;
  }

  /**
   * Adds a changed field to the patch; returns false if the change needs loading.
   *
   * @param written the new attribute; empty where it was removed, so that the default applies
   */
  private boolean takes(
      DocumentElement old,
      Optional<NodeType> type,
      String name,
      Optional<DocumentAttribute> written) {
    Optional<FieldDefinition> field = type.flatMap(known -> known.field(name));
    if (type.isEmpty() || OF_ENCODING.contains(name) || NAMING.contains(name)) {
      return false;
    }
    if (field.isEmpty()) {
      return true; // Such as class and id, which do not affect the scene.
    }
    FieldDefinition definition = field.get();
    if (definition.access() != AccessType.INPUT_OUTPUT
        || old.use().isPresent()
        || written.filter(text -> !text.flaws(definition.type()).isEmpty()).isPresent()) {
      return false;
    }
    fields.add(
        new ScenePatch.Field(
            placeOf(old),
            old.name(),
            name,
            written.isPresent()
                ? written.get().value(definition.type())
                : definition.defaultValue()));
    return true;
  }

  private static List<DocumentElement> withoutMetadata(DocumentElement element) {
    return element.children().stream().filter(child -> !isMetadata(child)).toList();
  }

  private static boolean isMetadata(DocumentElement element) {
    return element.name().startsWith("Metadata");
  }

  private boolean sameMetadata(DocumentElement old, DocumentElement now) {
    String was = metadata(before, old);
    String is = metadata(after, now);
    if (was.equals(is)) {
      return true;
    }
    if (tied(old, before, oldTree) || tied(now, after, tree)) {
      return false;
    }
    metadata.add(new ScenePatch.Metadata(placeOf(old), old.name(), is));
    return true;
  }

  private static String metadata(String text, DocumentElement of) {
    StringBuilder all = new StringBuilder();
    for (DocumentElement child : of.children()) {
      if (isMetadata(child)) {
        all.append(text, child.start(), child.end());
      }
    }
    return all.toString();
  }

  /** Whether metadata contain USE nodes, or nodes that are used elsewhere or routed to. */
  private static boolean tied(DocumentElement owner, String text, ElementTree in) {
    boolean[] found = {false};
    for (DocumentElement child : owner.children()) {
      if (isMetadata(child)) {
        child.visit(
            each ->
                found[0] |=
                    each.use().isPresent()
                        || each.def().filter(def -> in.used(def) || routed(def, text)).isPresent());
      }
    }
    return found[0];
  }

  private static boolean routed(String def, String text) {
    return text.contains("Node='" + def + "'") || text.contains("Node=\"" + def + "\"");
  }

  /** Compares two elements with equal text and records where their start tags have moved. */
  private boolean placed(DocumentElement old, DocumentElement now) {
    if (old.end() - old.start() != now.end() - now.start()
        || old.children().size() != now.children().size()) {
      return false;
    }
    place(old, now);
    for (int i = 0; i < old.children().size(); i++) {
      placed(old.children().get(i), now.children().get(i));
    }
    return true;
  }

  private void place(DocumentElement old, DocumentElement now) {
    Place was = placeOf(old);
    Place is = placeOf(now);
    if (!was.equals(is)) {
      moved.put(was, is);
    }
  }

  private static Place placeOf(DocumentElement element) {
    SourceLocation at = element.location();
    return new Place(at.line(), at.column());
  }
}
