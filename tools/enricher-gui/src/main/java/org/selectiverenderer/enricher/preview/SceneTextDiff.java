package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
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
import org.selectiverenderer.x3d.source.TextSource;
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
  private final DocumentSnapshot from;
  private final DocumentSnapshot to;

  /** The compared text before and after: all of it, or a part. */
  private final String before;

  private final String after;
  private final ElementTree oldTree;
  private final ElementTree tree;
  private final PartPlaces places;
  private final List<ScenePatch.Field> fields = new ArrayList<>();
  private final List<ScenePatch.Metadata> metadata = new ArrayList<>();
  private final List<ScenePatch.Name> names = new ArrayList<>();
  private final List<ScenePatch.Children> replaced = new ArrayList<>();
  private final Map<Place, Place> moved = new HashMap<>();

  private SceneTextDiff(NodeCatalogue catalogue, DocumentSnapshot before, DocumentSnapshot after)
      throws XmlParseException {
    this.catalogue = catalogue;
    from = before;
    to = after;
    this.before = before.text();
    this.after = after.text();
    oldTree = before.elements();
    tree = after.elements();
    places = PartPlaces.WHOLE;
  }

  /** Compares texts that stand for a part of the document, with what makes them well formed. */
  private SceneTextDiff(
      NodeCatalogue catalogue,
      DocumentSnapshot before,
      DocumentSnapshot after,
      String old,
      String now,
      PartPlaces places)
      throws XmlParseException {
    this.catalogue = catalogue;
    from = before;
    to = after;
    this.before = old;
    this.after = now;
    this.places = places;
    oldTree = ElementTree.of(new TextSource(before.name(), old), before.revision());
    tree = ElementTree.of(new TextSource(after.name(), now), after.revision());
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
      return same ? Optional.of(comparison.patch(Optional.empty())) : Optional.empty();
    } catch (XmlParseException e) {
      return Optional.empty(); // Loading the text reports the fault.
    }
  }

  /**
   * Compares a part of two snapshots that holds all that has changed.
   *
   * @return empty where the part does not tell enough
   */
  static Optional<ScenePatch> between(
      DocumentSnapshot before, DocumentSnapshot after, ChangedPart part, NodeCatalogue catalogue) {
    int start = part.range().from();
    int end = part.range().to() - part.range().growth();
    if (end < start) {
      return Optional.empty();
    }
    String old = before.text().substring(start, end);
    String now = after.text().substring(start, part.range().to());
    String head = part.kind() == ChangedPart.Kind.CONTENT ? "<" + part.owner() + ">" : "";
    String tail = "";
    if (part.kind() == ChangedPart.Kind.TAG) {
      if (old.endsWith("/>") != now.endsWith("/>")) {
        return Optional.empty();
      }
      tail = now.endsWith("/>") ? "" : "</" + part.owner() + ">";
    } else if (part.kind() == ChangedPart.Kind.CONTENT) {
      tail = "</" + part.owner() + ">";
    }
    PartPlaces places = new PartPlaces(part.place(), head.length());
    try {
      SceneTextDiff comparison =
          new SceneTextDiff(catalogue, before, after, head + old + tail, head + now + tail, places);
      ScenePatch.Shift shift =
          new ScenePatch.Shift(
              places.of(end(comparison.before, tail)), places.of(end(comparison.after, tail)));
      boolean taken =
          part.kind() == ChangedPart.Kind.CONTENT
              ? comparison.sameContent(part)
              : comparison.same(comparison.oldTree.root(), comparison.tree.root());
      return taken ? Optional.of(comparison.patch(Optional.of(shift))) : Optional.empty();
    } catch (XmlParseException e) {
      return Optional.empty(); // Loading the text reports the fault.
    }
  }

  /** Returns where a part ends, before what was added to make it well formed. */
  private static SourceLocation end(String text, String tail) {
    return new TextSource("", text).location(text.length() - tail.length());
  }

  private ScenePatch patch(Optional<ScenePatch.Shift> shift) {
    return new ScenePatch(
        from.revision(), to.revision(), fields, metadata, names, replaced, moved, shift);
  }

  /** Compares the children of the root element, which stands for the owner of a part. */
  private boolean sameContent(ChangedPart part) {
    List<DocumentElement> old = oldTree.root().children();
    List<DocumentElement> now = tree.root().children();
    if (Stream.concat(old.stream(), now.stream()).anyMatch(SceneTextDiff::isMetadata)) {
      return false;
    }
    int first = 0;
    int most = Math.min(old.size(), now.size());
    while (first < most && sameText(old.get(first), now.get(first))) {
      placed(old.get(first), now.get(first));
      first++;
    }
    int behind = 0;
    while (behind < most - first
        && sameText(old.get(old.size() - 1 - behind), now.get(now.size() - 1 - behind))) {
      placed(old.get(old.size() - 1 - behind), now.get(now.size() - 1 - behind));
      behind++;
    }
    List<DocumentElement> gone = old.subList(first, old.size() - behind);
    List<DocumentElement> come = now.subList(first, now.size() - behind);
    if (gone.size() == come.size() && sameAll(gone, come)) {
      return true;
    }
    fields.clear();
    metadata.clear();
    names.clear();
    return new ChildrenDiff(catalogue, from.text(), to.text(), places)
        .of(part, old.subList(0, first), gone, come, after)
        .map(replaced::add)
        .orElse(false);
  }

  private boolean sameAll(List<DocumentElement> old, List<DocumentElement> now) {
    for (int i = 0; i < old.size(); i++) {
      if (!same(old.get(i), now.get(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean sameText(DocumentElement old, DocumentElement now) {
    int length = old.end() - old.start();
    return length == now.end() - now.start()
        && before.regionMatches(old.start(), after, now.start(), length);
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
    return sameAll(oldChildren, children);
  }

  static boolean holdsCode(NodeType type) {
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
    if (type.isPresent() && name.equals("DEF") && old.use().isEmpty()) {
      return named(old, written.map(DocumentAttribute::text));
    }
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

  /** Adds another DEF name, unless anything else has the old name or the new one. */
  private boolean named(DocumentElement old, Optional<String> now) {
    boolean free =
        old.def().filter(def -> quoted(def, to.text())).isEmpty()
            && now.filter(def -> def.isBlank() || quoted(def, from.text())).isEmpty();
    return free && names.add(new ScenePatch.Name(placeOf(old), old.name(), old.def(), now));
  }

  /** Whether a text has a name as a value of any attribute. */
  static boolean quoted(String name, String text) {
    return text.contains("'" + name + "'") || text.contains('"' + name + '"');
  }

  private static List<DocumentElement> withoutMetadata(DocumentElement element) {
    return element.children().stream().filter(child -> !isMetadata(child)).toList();
  }

  static boolean isMetadata(DocumentElement element) {
    return element.name().startsWith("Metadata");
  }

  private boolean sameMetadata(DocumentElement old, DocumentElement now) {
    String was = metadata(before, old);
    String is = metadata(after, now);
    if (was.equals(is)) {
      return true;
    }
    if (tied(old, from.text()) || tied(now, to.text())) {
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
  private static boolean tied(DocumentElement owner, String text) {
    boolean[] found = {false};
    for (DocumentElement child : owner.children()) {
      if (isMetadata(child)) {
        child.visit(
            each ->
                found[0] |=
                    each.use().isPresent()
                        || each.def().filter(def -> used(def, text)).isPresent());
      }
    }
    return found[0];
  }

  private static boolean used(String def, String text) {
    return Stream.of("USE=", "Node=")
        .anyMatch(
            attribute ->
                text.contains(attribute + "'" + def + "'")
                    || text.contains(attribute + '"' + def + '"'));
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

  private Place placeOf(DocumentElement element) {
    return places.of(element.location());
  }
}
