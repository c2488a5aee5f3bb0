package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Child;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1State.Property;

/** Traverses the nodes of a file with their state, and makes the X3D elements of a scene. */
final class Vrml1Translator {
  /** The number of characters of nodes that are translated again where they look different. */
  private static final int LONGEST_COPIES = 1 << 24;

  /** A few seconds of reading: a colour table of 250 kB counts for a thousand shapes. */
  private static final int MOST_READ_AGAIN = 1 << 28;

  /** The number of characters for which a copy of a shorter node counts. */
  private static final int SHORTEST_COPY = 2048;

  /** The nodes that USE may add to those of a file, which are at most its characters. */
  private static final long MOST_USED_NODES = 10_000;

  private static final int ALL_CHILDREN = -3;

  /**
   * A named node that is being translated, and the properties of its surroundings that it needs.
   */
  private record Frame(Vrml1State entry, EnumSet<Property> reads) {}

  /**
   * A named node that has been translated.
   *
   * @param element its element; null if it shows nothing
   * @param exit the state after it
   * @param total the transformations that count after it
   */
  private record Translated(
      @Nullable X3dElement element,
      Vrml1State entry,
      EnumSet<Property> reads,
      Vrml1State exit,
      TransformChain total) {}

  private final ElementTreeBuilder document;
  private final X3dElement scene;
  private final Vrml1NodeTypes types;
  private final Vrml1Values values;
  private final SharedElements shared;
  private final VertexShapeTranslator vertexShapes;
  private final PrimitiveTranslator primitives;
  private final ViewTranslator views;
  private final Map<Vrml1Node, Translated> translated = new HashMap<>();
  private final Deque<Frame> frames = new ArrayDeque<>();
  private Vrml1State state = new Vrml1State();
  private int visits;
  private long copied;

  /**
   * Creates a translator.
   *
   * @param names the names of nodes in the file
   * @param scene the element for the nodes of the file
   */
  Vrml1Translator(ElementTreeBuilder document, Set<String> names, X3dElement scene) {
    this.document = document;
    this.scene = scene;
    values = new Vrml1Values(document);
    types = new Vrml1NodeTypes(document, values);
    shared = new SharedElements(names);
    AppearanceTranslator appearances =
        new AppearanceTranslator(document, values, shared, this::read);
    vertexShapes = new VertexShapeTranslator(document, values, shared, this::read, appearances);
    primitives = new PrimitiveTranslator(values, shared, this::read, appearances);
    views = new ViewTranslator(document, values);
  }

  /** Returns whether the scene has an OrthoViewpoint. */
  boolean usesOrthographicCamera() {
    return views.orthographic();
  }

  /**
   * Translates the nodes of a file.
   *
   * @throws XmlParseException at a limit; the elements so far are in the scene
   */
  void scene(Vrml1Node root) throws XmlParseException {
    children(root, new TranslationScope(scene, values, shared), 1);
  }

  private @Nullable Vrml1Node read(Property property) {
    Vrml1Node node = state.get(property);
    for (Frame frame : frames) {
      if (state.keeps(property, frame.entry())) {
        frame.reads().add(property);
      }
    }
    return node;
  }

  private void children(Vrml1Node node, TranslationScope scope, int depth)
      throws XmlParseException {
    for (Child child : node.children()) {
      visit(child, scope, depth);
    }
  }

  private void visit(Child child, TranslationScope scope, int depth) throws XmlParseException {
    Vrml1Node node = child.node();
    if (depth > document.limits().maxDepth()) {
      throw document.limit(
          child.at(), "nodes are nested more than " + document.limits().maxDepth() + " deep");
    }
    long most = Math.min(document.limits().maxNodes(), MOST_USED_NODES + document.text().length());
    if (++visits > most) {
      throw document.limit(
          child.at(), "there are more than " + most + " nodes, with those of each USE");
    }
    String type = types.type(node);
    if (type == null || child.use() && again(node, scope, child.at())) {
      return;
    }
    Optional<Property> property = Property.setBy(type);
    if (property.isPresent()) {
      state = state.with(property.get(), node);
      return;
    }
    switch (type) {
      case "Translation", "Rotation", "Scale", "Transform", "MatrixTransform" ->
          scope.transform(node, type);
      case "Group", "Separator", "TransformSeparator", "WWWAnchor" ->
          group(node, type, scope, depth);
      case "Switch" -> choose(node, scope, depth);
      case "LOD" -> levels(node, scope, depth);
      default -> leaf(node, type, scope, child.at());
    }
  }

  /** Uses a node again, if it looks as it did; returns false if it must be translated anew. */
  private boolean again(Vrml1Node node, TranslationScope scope, int at) {
    Translated known = translated.get(node);
    if (known == null || !known.entry().agrees(state, known.reads())) {
      return false;
    }
    known.reads().forEach(this::read);
    if (known.element() != null) {
      add(scope, shared.use(known.element(), at), node);
    }
    state = state.changed(known.entry(), known.exit());
    scope.transform(known.total());
    return true;
  }

  private void add(TranslationScope scope, X3dElement element, Vrml1Node node) {
    if (element.name().endsWith("Light")) {
      scope.addLight(element, matrix -> views.light(node, element.name(), matrix));
    } else {
      scope.target().add(element);
    }
  }

  private @Nullable Frame begin(Vrml1Node node) {
    if (node.name().isEmpty()) {
      return null;
    }
    Frame frame = new Frame(state, EnumSet.noneOf(Property.class));
    frames.push(frame);
    return frame;
  }

  private void end(
      Vrml1Node node, @Nullable Frame frame, @Nullable X3dElement element, TransformChain total) {
    if (frame != null) {
      frames.pop();
      translated.put(node, new Translated(element, frame.entry(), frame.reads(), state, total));
    }
  }

  private void group(Vrml1Node node, String type, TranslationScope scope, int depth)
      throws XmlParseException {
    Frame frame = begin(node);
    Vrml1State before = state;
    boolean anchor = type.equals("WWWAnchor") && !values.string(node, "name").isEmpty();
    X3dElement element = X3dElement.of(anchor ? "Anchor" : "Group", node);
    if (anchor) {
      views.anchor(element, node);
    }
    TranslationScope inner = new TranslationScope(element, values, shared);
    boolean leaks = type.equals("Group");
    try {
      children(node, inner, depth + 1);
    } finally {
      boolean saves = type.equals("Separator") || type.equals("WWWAnchor");
      boolean shows = saves && node.name().isPresent() || !element.children().isEmpty();
      if (shows) {
        shared.name(element, node);
        scope.target().add(TranslationScope.simplified(element));
      }
      state = saves ? before : state;
      TransformChain after = leaks ? inner.total() : new TransformChain(values);
      scope.transform(after);
      end(node, frame, shows ? element : null, after);
    }
  }

  /** Translates a Switch, whose chosen child changes the state of what follows. */
  private void choose(Vrml1Node node, TranslationScope scope, int depth) throws XmlParseException {
    int chosen = (int) values.numbers(node, "whichChild", -1)[0];
    if (camerasOnly(node)) {
      cameras(node, chosen, scope, depth);
    } else if (chosen == ALL_CHILDREN) {
      group(node, "Group", scope, depth);
    } else {
      choices(node, "Switch", chosen, scope, depth);
    }
  }

  private void levels(Vrml1Node node, TranslationScope scope, int depth) throws XmlParseException {
    choices(node, "LOD", -1, scope, depth);
  }

  private boolean camerasOnly(Vrml1Node node) {
    return !node.children().isEmpty()
        && node.children().stream().allMatch(child -> ViewTranslator.isCamera(child.node().type()));
  }

  /** Translates cameras, all of which can be chosen in X3D, and the first of which is taken. */
  private void cameras(Vrml1Node node, int chosen, TranslationScope scope, int depth)
      throws XmlParseException {
    List<Child> all = new ArrayList<>(node.children());
    if (chosen > 0 && chosen < all.size()) {
      all.add(0, all.remove(chosen));
    }
    for (Child camera : all) {
      visit(camera, scope, depth + 1);
    }
  }

  private void choices(
      Vrml1Node node, String element, int chosen, TranslationScope scope, int depth)
      throws XmlParseException {
    Frame frame = begin(node);
    Vrml1State before = state;
    Vrml1State after = state;
    TransformChain total = new TransformChain(values);
    X3dElement choices = X3dElement.of(element, node);
    setChoice(choices, node);
    boolean shows = false;
    try {
      for (int i = 0; i < node.children().size(); i++) {
        Child child = node.children().get(i);
        state = before;
        X3dElement group = new X3dElement("Group", child.at(), child.node().end());
        TranslationScope inner = new TranslationScope(group, values, shared);
        visit(child, inner, depth + 1);
        choices.add(TranslationScope.simplified(group));
        shows |= !group.children().isEmpty();
        if (i == chosen) {
          after = state;
          total = inner.total();
        }
      }
    } finally {
      state = after;
      if (shows) {
        shared.name(choices, node);
        scope.target().add(choices);
      }
      scope.transform(total);
      end(node, frame, shows ? choices : null, total);
    }
  }

  private void setChoice(X3dElement choices, Vrml1Node node) {
    for (Map.Entry<String, Field> field : node.fields().entrySet()) {
      switch (field.getKey()) {
        case "whichChild" ->
            choices.set("whichChoice", values.text(field.getValue()).strip(), field.getValue());
        case "range", "center" ->
            choices.set(field.getKey(), values.text(field.getValue()).strip(), field.getValue());
        default -> {
          // declarations of fields
        }
      }
    }
  }

  private void leaf(Vrml1Node node, String type, TranslationScope scope, int at)
      throws XmlParseException {
    boolean copy = translated.containsKey(node);
    copied += copy ? Math.max(SHORTEST_COPY, node.end() - node.start()) : 0;
    if (values.readAgain() > MOST_READ_AGAIN) {
      throw document.limit(
          at,
          "values are read again for each of the shapes that they count for, more than "
              + DecimalFormatter.grouped(MOST_READ_AGAIN)
              + " characters of them");
    }
    if (copied + values.copied() > LONGEST_COPIES) {
      throw document.limit(
          at,
          "nodes that are used with another state are copied, and these copies have more than "
              + DecimalFormatter.grouped(LONGEST_COPIES)
              + " characters");
    }
    Frame frame = begin(node);
    X3dElement element =
        switch (type) {
          case "PerspectiveCamera", "OrthographicCamera" -> views.camera(node, type);
          case "DirectionalLight", "PointLight", "SpotLight" -> views.light(node, type, null);
          case "Background", "Fog", "NavigationInfo" ->
              views.environment(node, type, types.fields(type));
          case "Info" -> views.information(node);
          case "WWWInline" -> views.inline(node);
          case "IndexedFaceSet", "IndexedLineSet", "PointSet" ->
              vertexShapes.shape(node, type, copy);
          default -> primitives.shape(node, type);
        };
    if (element != null) {
      shared.name(element, node);
      add(scope, element, node);
    }
    end(node, frame, element, new TransformChain(values));
  }
}
