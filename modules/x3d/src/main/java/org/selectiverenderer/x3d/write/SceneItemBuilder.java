package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StatementNames;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Place;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/**
 * Converts the elements of a document to items for writing: determines the type of each value, the
 * field of each node, and the positions of comments. Invalid content, and what the encoding cannot
 * hold, is reported and left out. For one document.
 */
final class SceneItemBuilder {
  private final NodeCatalogue catalogue;
  private final boolean classic;
  private final ProblemCollector problems;
  private final CharacterRules characters;
  private final ValueBuilder values;
  private final List<XmlDocument.Comment> comments;
  private int passed;

  private SceneItemBuilder(
      XmlDocument document,
      NodeCatalogue catalogue,
      SceneFormat format,
      ProblemCollector problems) {
    this.catalogue = catalogue;
    classic = format == SceneFormat.CLASSIC;
    this.problems = problems;
    characters = new CharacterRules(format, problems);
    values = new ValueBuilder(document, catalogue, format, characters, problems);
    comments = new ArrayList<>(document.comments());
    comments.sort(Comparator.comparingInt(XmlDocument.Comment::offset));
  }

  /** Returns the document's root element with the comments around it. */
  static List<SceneItem> of(
      XmlDocument document,
      NodeCatalogue catalogue,
      SceneFormat format,
      ProblemCollector problems) {
    SceneItemBuilder items = new SceneItemBuilder(document, catalogue, format, problems);
    List<SceneItem> all = new ArrayList<>();
    DocumentElement root = document.root().orElse(null);
    if (document.rootFault().isPresent() && root != null) {
      problems.error(root.location(), document.rootFault().get() + "; nothing is written");
    } else if (root != null) {
      items.comments(root.start(), all);
      items.element(root, null, new PrototypeScope(null), new HashSet<>()).ifPresent(all::add);
      items.comments(Integer.MAX_VALUE, all);
    }
    return all;
  }

  private void comments(int before, List<SceneItem> into) {
    while (passed < comments.size() && comments.get(passed).offset() < before) {
      XmlDocument.Comment comment = comments.get(passed++);
      String text = characters.comment(comment.text().strip(), comment::location);
      if (!text.isEmpty()) {
        into.add(new SceneItem.Words(text));
      }
    }
  }

  /**
   * Returns an element with its content; empty, after a message, if it cannot be written.
   *
   * @param parent the node type of its parent; null if that is a statement
   * @param taken the fields of the parent that have the one node that they can have
   */
  private Optional<Element> element(
      DocumentElement element, @Nullable NodeType parent, PrototypeScope known, Set<String> taken) {
    DocumentElement named = element.use().map(known::node).orElse(element);
    String name = named.name();
    boolean instance = name.equals("ProtoInstance");
    NodeType type = instance ? null : catalogue.find(name).orElse(null);
    String fault = fault(element, type, parent);
    if (fault != null) {
      return leftOut(element, fault);
    }
    String lost = classic ? notInClassicVrml(element, type, known) : null;
    if (lost != null) {
      problems.warning(element.location(), lost);
      return without(element);
    }
    if (!name.equals(element.name())) {
      problems.warning(
          element.location(),
          "%s is %s, not %s; the %s is used"
              .formatted(
                  element.use().orElse(""),
                  SpellingSuggester.one(name),
                  SpellingSuggester.one(element.name()),
                  name));
    }
    NodeType stands = instance ? known.node(named.text("name").orElse(""), catalogue) : type;
    Place place = SceneItem.NOWHERE;
    if (parent != null && (instance || type != null)) {
      Place found = NodePlacement.of(element, parent, stands, instance, taken);
      if (found == null) {
        return leftOut(element, notAllowed(name, parent.name()));
      }
      if (!found.multiple() && !taken.add(found.name())) {
        return leftOut(
            element,
            "the %s of %s can be only one node, and there is one already; this %s is left out"
                .formatted(found.name(), SpellingSuggester.one(parent.name()), name));
      }
      place = found;
    } else if (name.equals("fieldValue")) {
      FieldType field = known.type(element);
      boolean several = field == null ? element.children().size() > 1 : field.multiple();
      place = new Place("", several, true);
    }
    String use = element.use().map(text -> values.name(element, "USE", text)).orElse("");
    if (!use.isEmpty()) {
      List<SceneItem> items = new ArrayList<>();
      inner(element, items);
      return Optional.of(new Element(name, type, "", use, place, List.of(), items, ""));
    }
    element.def().ifPresent(def -> define(def, element, known));
    return Optional.of(complete(element, type, place, known));
  }

  /** Adds a name to its scope; a name of two nodes is ambiguous where statements are moved. */
  private void define(String def, DocumentElement element, PrototypeScope known) {
    DocumentElement before = known.node(def);
    if (before != null) {
      problems.warning(
          element.location(),
          "the name %s is used already at %s; give this %s another one"
              .formatted(FieldTokenizer.quote(def), before.location(), element.name()));
    }
    known.define(def, element);
  }

  private Element complete(
      DocumentElement element, @Nullable NodeType type, Place place, PrototypeScope known) {
    String name = element.name();
    List<SceneItem> items = new ArrayList<>();
    List<Value> given = values.of(element, type, known, items);
    PrototypeScope inner = name.equals("ProtoDeclare") ? new PrototypeScope(known) : known;
    children(element, type, inner, items);
    if (name.equals("ProtoDeclare") || name.equals("ExternProtoDeclare")) {
      known.declare(element);
    }
    boolean code = type != null && type.field("sourceCode").isPresent();
    String source =
        code
            ? characters.written(
                InlineCodeConverter.of(type, given, element.text()), element::textLocation, true)
            : "";
    String def = element.def().map(text -> values.name(element, "DEF", text)).orElse("");
    return new Element(name, type, def, "", place, given, items, source);
  }

  private void children(
      DocumentElement element,
      @Nullable NodeType type,
      PrototypeScope known,
      List<SceneItem> into) {
    Set<String> taken = new HashSet<>();
    DocumentElement body = null;
    for (DocumentElement child : element.children()) {
      body = child.name().equals("ProtoBody") ? child : body;
    }
    // the catalogue has the element, too, for metadata in it
    boolean instance = element.name().equals("ProtoInstance");
    NodeType parent = instance ? catalogue.find(element.name()).orElse(null) : type;
    boolean nodes = true;
    boolean one = false;
    if (element.name().equals("field") || element.name().equals("fieldValue")) {
      FieldType field = StatementGrammar.type(element, "value", known);
      boolean declares = element.name().equals("field");
      AccessType access = declares ? StatementGrammar.access(element) : AccessType.INPUT_OUTPUT;
      boolean extern = element.parent().filter(p -> p.name().startsWith("Extern")).isPresent();
      nodes =
          (field == null || field.isNode()) && access != null && access.initialisable() && !extern;
      one = field == FieldType.SFNode;
    }
    for (DocumentElement child : element.children()) {
      comments(child.start(), into);
      boolean node =
          child.name().equals("ProtoInstance") || catalogue.find(child.name()).isPresent();
      if (child.name().equals("ProtoBody") && child != body) {
        leftOut(child, "a ProtoDeclare can have only one ProtoBody; this one is left out");
      } else if (type != null && child.name().equals("field") && repeated(child, taken)) {
        inner(child, into);
      } else if (!nodes) {
        leftOut(child, notAllowed(child.name(), element.name() + " of this type"));
      } else if (one && (classic && !node || node && taken.contains(""))) {
        leftOut(child, "an SFNode can be only one node; this " + child.name() + " is left out");
      } else {
        Optional<Element> item =
            element(child, parent, known, taken).filter(inside -> valued(inside, child, known));
        item.ifPresent(into::add);
        if (one && node && item.isPresent()) {
          taken.add("");
        }
      }
    }
    inner(element, into);
  }

  /**
   * Returns whether a node has declared a field before. ClassicVRML repeats a declaration for each
   * further IS of the field; any other repetition is reported.
   */
  private boolean repeated(DocumentElement field, Set<String> taken) {
    String name = field.text("name").orElse("");
    boolean before = !taken.add("field " + name);
    String all = "field " + name + " " + field.text("type") + " " + field.text("accessType");
    if (taken.add(all) && before || before && field.text("value").isPresent()) {
      problems.error(
          field.location(), "there is a field " + name + " already; this one is left out");
    }
    return before;
  }

  /** Returns whether a fieldValue has a value; false after a message. */
  private boolean valued(Element item, DocumentElement element, PrototypeScope known) {
    FieldType type = item.name().equals("fieldValue") ? known.type(element) : FieldType.SFNode;
    boolean valued =
        type != null && type.isNode()
            || !item.values().stream().allMatch(value -> value.name().equals("name"))
            || item.items().stream().anyMatch(Element.class::isInstance);
    if (!valued) {
      problems.error(element.location(), "this fieldValue has no value; it is left out");
    }
    return valued;
  }

  /** Adds the remaining comments in an element. */
  private void inner(DocumentElement element, List<SceneItem> into) {
    comments(element.end() < 0 ? Integer.MAX_VALUE : element.end(), into);
  }

  private static String notAllowed(String child, String parent) {
    return "%s is not allowed in %s; it is left out".formatted(one(child), one(parent));
  }

  private static String one(String element) {
    return StatementNames.is(element) ? element : SpellingSuggester.one(element);
  }

  /** Returns what is wrong with an element; null for nothing. */
  private static @Nullable String fault(
      DocumentElement element, @Nullable NodeType type, @Nullable NodeType parent) {
    String name = element.name();
    DocumentElement around = element.parent().orElse(null);
    if (type == null && !StatementNames.is(name)) {
      return "unknown element " + name + "; it and its children are left out";
    }
    if (!StatementGrammar.contains(around, parent, name)) {
      return notAllowed(name, around == null ? "the file" : around.name());
    }
    String fault = StatementGrammar.fault(element);
    if (fault != null) {
      return fault;
    }
    if (element.use().filter(String::isEmpty).isPresent()) {
      return "USE needs the name of a node; this " + name + " is left out";
    }
    return null;
  }

  /** Returns why ClassicVRML cannot hold an element; null if it can. */
  private static @Nullable String notInClassicVrml(
      DocumentElement element, @Nullable NodeType type, PrototypeScope known) {
    String name = element.name();
    DocumentElement around = element.parent().orElse(null);
    if (type != null && around != null && around.name().equals("ProtoInstance")) {
      return "ClassicVRML has no place for %s in an instance; it is left out"
          .formatted(SpellingSuggester.one(name));
    }
    String prototype = element.text("name").orElse("");
    if (name.equals("ProtoInstance") && element.use().isEmpty() && !known.has(prototype)) {
      return "no prototype above has the name " + prototype + "; the instance is left out";
    }
    boolean late =
        name.equals("head")
            && around != null
            && around.children().stream()
                .anyMatch(c -> c.name().equals("Scene") && c.start() < element.start());
    return late ? "in ClassicVRML a head must precede the Scene; this one is left out" : null;
  }

  /** Leaves out an element in which something is wrong, with the comments in it. */
  private Optional<Element> leftOut(DocumentElement element, String why) {
    SourceLocation at = element.location();
    problems.error(at, why);
    return without(element);
  }

  private Optional<Element> without(DocumentElement element) {
    inner(element, new ArrayList<>());
    return Optional.empty();
  }
}
