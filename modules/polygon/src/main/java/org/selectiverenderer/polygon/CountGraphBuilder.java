package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;
import org.selectiverenderer.x3d.tessellate.InstancedShapeTransforms;

/**
 * Builds the count graph of files that are read, and reports the problems of each file when it
 * first occurs. Objects and areas of inlined files count too, as the controller sees them.
 */
final class CountGraphBuilder {
  /** The largest number of copies of a triangle that the browser draws. */
  private static final int MOST_COPIES = 4_000_000 / 3;

  private final ProblemCollector problems;
  private final Map<ParsedNode, CountGraphNode> items = new IdentityHashMap<>();
  private final Map<ParsedNode, TextureUse> uses = new IdentityHashMap<>();
  private final List<CountedTexture> varying = new ArrayList<>();
  private final Map<FilePolygonMeasurement, CountGraphNode> contents = new IdentityHashMap<>();
  private final Set<FilePolygonMeasurement> open = new HashSet<>();
  private final Map<FilePolygonMeasurement, NodeNames> names = new IdentityHashMap<>();
  private final Set<String> taken = new HashSet<>();
  private final Map<String, ParsedNode> named = new LinkedHashMap<>();
  private final CountGraphNode root;

  /** Builds the graph of a scene. */
  CountGraphBuilder(FilePolygonMeasurement main, ProblemCollector problems) {
    this.problems = problems;
    this.root = content(main, "", null);
  }

  /** Returns the root of the scene. */
  CountGraphNode root() {
    return root;
  }

  /** Returns the textures whose pictures are qualities of objects. */
  List<CountedTexture> varying() {
    return Collections.unmodifiableList(varying);
  }

  /** Returns the graph node of every X3D node that has one. */
  Map<ParsedNode, CountGraphNode> all() {
    return Collections.unmodifiableMap(items);
  }

  /**
   * Returns the nodes by DEF name, of the scene's own file and of those it inlines; a name that
   * occurs in several files means the node of the first one.
   */
  Map<String, ParsedNode> named() {
    return Collections.unmodifiableMap(named);
  }

  /** Returns the graph node of an X3D node; empty if the node is neither drawn nor an area. */
  Optional<CountGraphNode> of(@Nullable ParsedNode node) {
    return Optional.ofNullable(items.get(node));
  }

  /**
   * @param path the names of the Inlines that lead to the file, as {@link NodeNames} wants it
   * @param inline the Inline that names the file; null for the scene's own file
   */
  private CountGraphNode content(
      FilePolygonMeasurement file, String path, @Nullable ParsedNode inline) {
    CountGraphNode known = contents.get(file);
    if (known != null) {
      return known;
    }
    List<Problem> found = file.problemList();
    (inline == null ? found : Problem.withReference(found, "Inline", inline.location()))
        .forEach(problems::add);
    open.add(file);
    names.put(file, new NodeNames(path, taken));
    file.file().named().forEach(named::putIfAbsent);
    CountGraphNode made =
        new CountGraphNode.Builder(null).children(items(file.file().nodes(), file)).build();
    open.remove(file);
    contents.put(file, made);
    return made;
  }

  private List<CountGraphNode> items(List<ParsedNode> nodes, FilePolygonMeasurement file) {
    List<CountGraphNode> made = new ArrayList<>(nodes.size());
    for (ParsedNode node : nodes) {
      made.add(item(node, file));
    }
    return made;
  }

  private CountGraphNode item(ParsedNode node, FilePolygonMeasurement file) {
    CountGraphNode known = items.get(node);
    if (known == null) {
      known = make(node, file);
      items.put(node, known);
    }
    return known;
  }

  private CountGraphNode make(ParsedNode node, FilePolygonMeasurement file) {
    String name = names.get(file).of(node);
    CountGraphNode.Builder builder = new CountGraphNode.Builder(node).name(name);
    if (DrawableNodeClassifier.isShape(node)) {
      Optional<ParsedNode> geometry = DrawableNodeClassifier.geometry(node);
      geometry.map(file::size).map(size -> placed(node, size)).ifPresent(builder::size);
      if (geometry.isPresent()) {
        builder.drawn(textures(node, file));
      }
    } else if (DrawableNodeClassifier.isInline(node)) {
      fill(node, name, file, builder);
    } else {
      List<ParsedNode> children = DrawableNodeClassifier.children(node);
      enrich(node, name, children.size(), file, builder);
      builder.children(items(children, file));
      GroupingNodeChildren.placement(node).ifPresent(builder::placement);
    }
    return builder.build();
  }

  private List<TextureUse> textures(ParsedNode shape, FilePolygonMeasurement file) {
    List<TextureUse> found = new ArrayList<>();
    if (shape.node("appearance") instanceof ParsedNode appearance) {
      NodeTraversal.visit(
          List.of(appearance),
          node -> {
            String type = node.type().name();
            if (type.equals("ImageTexture") || type.equals("PixelTexture")) {
              found.add(uses.computeIfAbsent(node, unknown -> new TextureUse(node, file)));
            }
          });
    }
    return found;
  }

  private static GeometrySize placed(ParsedNode shape, GeometrySize size) {
    return DrawableNodeClassifier.isInstanced(shape)
        ? size.copied(InstancedShapeTransforms.of(shape, MOST_COPIES))
        : size;
  }

  private void fill(
      ParsedNode inline, String name, FilePolygonMeasurement file, CountGraphNode.Builder builder) {
    FilePolygonMeasurement content = file.content(inline).orElse(null);
    if (content == null) {
      return;
    }
    if (open.contains(content)) {
      problems.error(
          inline.location(),
          "Inline %s includes itself and is left out".formatted(content.file().source()));
      return;
    }
    builder.children(List.of(content(content, names.get(file).path() + name + "/", inline)));
    double scale = content.file().unitLength() / file.file().unitLength();
    if (scale != 1) {
      builder.placement(new Matrix4d().scale(scale));
    }
  }

  private void enrich(
      ParsedNode node,
      String name,
      int children,
      FilePolygonMeasurement file,
      CountGraphNode.Builder builder) {
    SchemaReader reader =
        new SchemaReader(
            problem ->
                problems.warning(
                    ((NodeViewMetadata) problem.metadata()).node().location(),
                    name + ": " + problem.message()));
    if (DrawableNodeClassifier.isSwitch(node)) {
      builder.versions(
          NodeViewMetadata.of(node).flatMap(data -> reader.switchNode(data, children)));
      NodeViewMetadata.of(node)
          .map(reader::fieldQualities)
          .orElse(List.of())
          .forEach(quality -> vary(quality, file));
    } else if (DrawableNodeClassifier.isSensor(node)) {
      builder.area(NodeViewMetadata.of(node).flatMap(reader::sensor));
    }
  }

  private void vary(FieldQuality quality, FilePolygonMeasurement file) {
    ParsedNode target = file.file().named().get(quality.target().node());
    if (target != null
        && target.type().name().equals("ImageTexture")
        && quality.target().field().equals("url")) {
      varying.add(new CountedTexture(target, quality));
    }
  }

  /**
   * Makes the names of a file's nodes as the controller does: the DEF name, else type and number.
   * The names of the Inlines that lead to the file are prefixed where the name is made up or occurs
   * in another file too.
   */
  private static final class NodeNames {
    private final String path;
    private final Set<String> taken;
    private final Map<String, Integer> numbers = new HashMap<>();

    /**
     * @param path the names of the Inlines that lead to the file, each followed by a slash; empty
     *     for the scene's own file
     * @param taken names of Switches and ProximitySensors of all files so far, to which these are
     *     added
     */
    NodeNames(String path, Set<String> taken) {
      this.path = path;
      this.taken = taken;
    }

    String path() {
      return path;
    }

    /** Returns the name of a node; to be called once for each node. */
    String of(ParsedNode node) {
      String type = node.type().name();
      int number = numbers.merge(type, 1, Integer::sum);
      String def = node.name();
      if (DrawableNodeClassifier.isInline(node)) { // only a part of paths, which need not be unique
        return def != null ? def.strip() : type + "#" + number;
      }
      if (def == null) {
        return path + type + "#" + number;
      }
      String name = def.strip();
      boolean told = DrawableNodeClassifier.isSwitch(node) || DrawableNodeClassifier.isSensor(node);
      return !told || taken.add(name) ? name : path + name;
    }
  }
}
