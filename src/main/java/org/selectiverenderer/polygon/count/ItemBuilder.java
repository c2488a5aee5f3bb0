package org.selectiverenderer.polygon.count;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.tessellate.InstancePlaces;
import org.selectiverenderer.geometry.tessellate.NodeContent;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.nodes.NodeMetadata;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Builds the count graph of files that are read, and reports the problems of each file when it
 * first occurs. Objects and areas of inlined files count too, as the controller sees them.
 */
final class ItemBuilder {
  /** The largest number of copies of a triangle that the browser draws. */
  private static final int MOST_COPIES = 4_000_000 / 3;

  private final Problems problems;
  private final Map<ParsedNode, CountedItem> items = new IdentityHashMap<>();
  private final Map<CountedFile, CountedItem> contents = new IdentityHashMap<>();
  private final Set<CountedFile> open = new HashSet<>();
  private final Map<CountedFile, ItemNames> names = new IdentityHashMap<>();
  private final Set<String> taken = new HashSet<>();
  private final Map<String, ParsedNode> named = new LinkedHashMap<>();
  private final CountedItem root;

  /** Builds the graph of a scene. */
  ItemBuilder(CountedFile main, Problems problems) {
    this.problems = problems;
    this.root = content(main, "");
  }

  /** Returns the root of the scene. */
  CountedItem root() {
    return root;
  }

  /** Returns the graph node of every X3D node that has one. */
  Map<ParsedNode, CountedItem> all() {
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
  Optional<CountedItem> of(@Nullable ParsedNode node) {
    return Optional.ofNullable(items.get(node));
  }

  /**
   * @param path the names of the Inlines that lead to the file, as {@link ItemNames} wants it
   */
  private CountedItem content(CountedFile file, String path) {
    CountedItem known = contents.get(file);
    if (known != null) {
      return known;
    }
    file.problemList().forEach(problems::add);
    open.add(file);
    names.put(file, new ItemNames(path, taken));
    file.file().named().forEach(named::putIfAbsent);
    CountedItem made =
        new CountedItem.Builder(null).children(items(file.file().nodes(), file)).build();
    open.remove(file);
    contents.put(file, made);
    return made;
  }

  private List<CountedItem> items(List<ParsedNode> nodes, CountedFile file) {
    List<CountedItem> made = new ArrayList<>(nodes.size());
    for (ParsedNode node : nodes) {
      made.add(item(node, file));
    }
    return made;
  }

  private CountedItem item(ParsedNode node, CountedFile file) {
    CountedItem known = items.get(node);
    if (known == null) {
      known = make(node, file);
      items.put(node, known);
    }
    return known;
  }

  private CountedItem make(ParsedNode node, CountedFile file) {
    String name = names.get(file).of(node);
    CountedItem.Builder builder = new CountedItem.Builder(node).name(name);
    if (Structure.isShape(node)) {
      Structure.geometry(node)
          .map(file::size)
          .map(size -> placed(node, size))
          .ifPresent(builder::size);
    } else if (Structure.isInline(node)) {
      fill(node, name, file, builder);
    } else {
      List<ParsedNode> children = Structure.children(node);
      enrich(node, name, children.size(), builder);
      builder.children(items(children, file));
      NodeContent.placement(node).ifPresent(builder::placement);
    }
    return builder.build();
  }

  private static Size placed(ParsedNode shape, Size size) {
    return Structure.isInstanced(shape) ? size.copied(InstancePlaces.of(shape, MOST_COPIES)) : size;
  }

  private void fill(ParsedNode inline, String name, CountedFile file, CountedItem.Builder builder) {
    CountedFile content = file.content(inline).orElse(null);
    if (content == null) {
      return;
    }
    if (open.contains(content)) {
      problems.error(
          inline.location(),
          "Inline %s includes itself and is left out".formatted(content.file().source()));
      return;
    }
    builder.children(List.of(content(content, names.get(file).path() + name + "/")));
    double scale = content.file().unitLength() / file.file().unitLength();
    if (scale != 1) {
      builder.placement(new Matrix4d().scale(scale));
    }
  }

  private void enrich(ParsedNode node, String name, int children, CountedItem.Builder builder) {
    SchemaReader reader =
        new SchemaReader(
            problem ->
                problems.warning(
                    ((NodeMetadata) problem.metadata()).node().location(),
                    name + ": " + problem.message()));
    if (Structure.isSwitch(node)) {
      builder.versions(NodeMetadata.of(node).flatMap(data -> reader.switchNode(data, children)));
    } else if (Structure.isSensor(node)) {
      builder.area(NodeMetadata.of(node).flatMap(reader::sensor));
    }
  }
}
