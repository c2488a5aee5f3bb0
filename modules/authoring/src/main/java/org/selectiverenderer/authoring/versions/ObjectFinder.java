package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/** Finds the elements of an object by its DEF name. */
final class ObjectFinder {
  /** The URL pattern of a version's file. */
  static final Pattern VERSION_URL = Pattern.compile("(?s)(.*)_v(\\d+)(\\.[A-Za-z0-9]+)");

  private static final String SWITCH = "Switch_";

  /** The prefixes of object names in the thesis's scenes. */
  private static final List<String> PREFIXES =
      List.of("Transform_", "Group_", "Shape_", "Inline_", SWITCH);

  private final ElementNodeMapping scene;
  private final ProblemCollector problems;

  ObjectFinder(ElementNodeMapping scene, ProblemCollector problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /** Finds the object; empty after a problem has been reported. */
  Optional<ObjectElements> find(String def) {
    List<DocumentElement> named = named(def);
    String name = name(def);
    if (named.isEmpty()) {
      List<DocumentElement> choices = named(SWITCH + name);
      if (choices.size() == 1) {
        return object(choices.get(0), name);
      }
      Optional<DocumentElement> inside = inPrototype(def);
      if (inside.isPresent()) {
        return refuse(
            inside.get().location(),
            "the object '" + def + "' is part of a prototype, where it cannot be replaced");
      }
      return refuse(
          SourceLocation.of(scene.file().source()),
          "there is no node with DEF '" + def + "' in the scene");
    }
    if (named.size() > 1) {
      return refuse(
          named.get(1).location(),
          "DEF '" + def + "' is the name of several nodes; give each its own name");
    }
    DocumentElement element = named.get(0);
    return object(element, name);
  }

  private Optional<DocumentElement> inPrototype(String def) {
    List<DocumentElement> found = new ArrayList<>();
    scene
        .elements()
        .root()
        .visit(
            element -> {
              if (element.def().filter(def::equals).isPresent()) {
                found.add(element);
              }
            });
    return found.stream().findFirst();
  }

  /** Finds the object of an element that need not have a name yet. */
  Optional<ObjectElements> at(DocumentElement element, String def) {
    return object(element, name(def));
  }

  private Optional<ObjectElements> object(DocumentElement element, String name) {
    NodeView node = scene.node(element);
    if (node == null) {
      return refuse(element.location(), "the object '" + name + "' is not a node of the scene");
    }
    boolean instance = element.name().equals("ProtoInstance");
    if (node.type().name().equals("Switch") && !instance) {
      return versioned(element, name);
    }
    if (!node.type().is("X3DChildNode")) {
      return element
          .parent()
          .filter(parent -> scene.node(parent) != null)
          .map(parent -> object(parent, name))
          .orElseGet(
              () -> refuse(element.location(), "'" + name + "' is not an object of the scene"));
    }
    if (instance) {
      return draws(node)
          ? Optional.of(new ObjectElements.Whole(name, List.of(element)))
          : faceless(element, name);
    }
    boolean group =
        node.type().is("X3DGroupingNode") && !Set.of("LOD", "CADFace").contains(node.type().name());
    if (!group) {
      return Optional.of(new ObjectElements.Whole(name, List.of(element)));
    }
    List<DocumentElement> visible = new ArrayList<>();
    for (DocumentElement child : element.children()) {
      if (drawn(child)) {
        visible.add(child);
      }
    }
    if (visible.size() == 1 && "Switch".equals(visible.get(0).name())) {
      return versioned(visible.get(0), name);
    }
    if (visible.isEmpty()) {
      return faceless(element, name);
    }
    return Optional.of(new ObjectElements.Whole(name, visible));
  }

  private Optional<ObjectElements> faceless(DocumentElement element, String name) {
    return refuse(
        element.location(),
        "the object '" + name + "' has no faces, so there is nothing to reduce");
  }

  /** Returns whether an element is drawn: a shape, an Inline, or a group with one of them. */
  private boolean drawn(DocumentElement element) {
    NodeView node = scene.node(element);
    if (node == null || element.text("containerField").orElse("children").equals("proxy")) {
      return false;
    }
    return draws(node);
  }

  private static boolean draws(NodeView node) {
    if (node.type().is("X3DShapeNode") || node.type().name().equals("Inline")) {
      return true;
    }
    return node.type().is("X3DGroupingNode")
        && node.type().field("children").isPresent()
        && node.nodes("children").stream().anyMatch(ObjectFinder::draws);
  }

  private Optional<ObjectElements> versioned(DocumentElement choice, String name) {
    List<DocumentElement> inlines =
        choice.children().stream().filter(child -> "Inline".equals(child.name())).toList();
    for (int i = 0; i < inlines.size(); i++) {
      String number = url(inlines.get(i)).map(url -> number(url)).orElse("");
      if (!number.equals(String.valueOf(i + 1))) {
        inlines = List.of();
      }
    }
    if (inlines.isEmpty()) {
      List<DocumentElement> drawn = choice.children().stream().filter(this::drawn).toList();
      NodeView node = scene.node(choice);
      if (drawn.size() == 1 && node != null && node.nodes("children").size() == 1) {
        return Optional.of(new ObjectElements.Whole(name, drawn, Optional.of(choice)));
      }
      return refuse(
          choice.location(),
          "the object '"
              + name
              + "' has a Switch already, but not one of Inlines of NAME_v1.x3d, NAME_v2.x3d and so"
              + " on; it is left as it is");
    }
    return Optional.of(new ObjectElements.Versioned(name, choice, inlines));
  }

  private static String number(String url) {
    var matcher = VERSION_URL.matcher(url);
    return matcher.matches() ? matcher.group(2) : "";
  }

  private Optional<String> url(DocumentElement inline) {
    NodeView node = scene.node(inline);
    return node == null || node.strings("url").length == 0
        ? Optional.empty()
        : Optional.of(node.strings("url")[0]);
  }

  private List<DocumentElement> named(String def) {
    List<DocumentElement> found = new ArrayList<>();
    ElementScope.visit(
        scene.elements().root(),
        element -> {
          if (element.def().filter(def::equals).isPresent()) {
            found.add(element);
          }
        });
    return found;
  }

  /** Returns the object's own name: TrashCan for Transform_TrashCan and for Switch_TrashCan. */
  static String name(String def) {
    for (String prefix : PREFIXES) {
      if (def.startsWith(prefix) && def.length() > prefix.length()) {
        return def.substring(prefix.length());
      }
    }
    return def;
  }

  private Optional<ObjectElements> refuse(SourceLocation location, String message) {
    problems.error(location, message);
    return Optional.empty();
  }
}
