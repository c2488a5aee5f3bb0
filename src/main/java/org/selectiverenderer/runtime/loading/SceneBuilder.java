package org.selectiverenderer.runtime.loading;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.runtime.nodes.InlineNode;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Route;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.FieldType;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.NodeType;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dFile;

/**
 * Makes running scenes of files that are read, Inlines filled with scenes of their own. Reports the
 * problems of each file when it is first met, in document order.
 */
final class SceneBuilder {
  /**
   * Nodes above which the rest of a scene is left out, so that Inlines cannot multiply for ever.
   */
  static final int MAX_NODES = 8_000_000;

  private final NodeFactory factory;
  private final NodeType groupType;
  private final AssetStore assets;
  private final Problems problems;
  private final Set<FileContent> reported = new HashSet<>();
  private final Set<String> keptOnly = new HashSet<>();
  private int nodes;

  SceneBuilder(NodeCatalogue catalogue, NodeFactory factory, AssetStore assets, Problems problems) {
    this.factory = factory;
    this.groupType = catalogue.get("Group");
    this.assets = assets;
    this.problems = problems;
  }

  /**
   * @param including the files that this one is inlined by, outermost first
   */
  Scene build(FileContent content, List<Path> including) {
    if (reported.add(content)) {
      content.problemList().forEach(problems::add);
    }
    return new FileBuilder(content, including).build();
  }

  /** Builds one file: DEF names and routes are its own. */
  private final class FileBuilder {
    private final FileContent content;
    private final List<Path> files;
    private final Scene scene;
    private final Map<ParsedNode, Node> named = new IdentityHashMap<>();

    FileBuilder(FileContent content, List<Path> including) {
      this.content = content;
      files = new ArrayList<>(including);
      files.add(content.path());
      X3dFile file = content.file();
      Node root = factory.make(groupType, null, Location.of(file.source()));
      scene =
          new Scene(
              root,
              file.source(),
              file.version(),
              file.profile(),
              file.components(),
              file.unitLength());
    }

    Scene build() {
      X3dFile file = content.file();
      List<Node> roots = new ArrayList<>(file.nodes().size());
      file.nodes().forEach(node -> make(node).ifPresent(roots::add));
      scene.root().init(groupType.indexOf("children"), List.copyOf(roots));
      file.meta().forEach(meta -> scene.meta().put(meta.name(), meta.content()));
      file.named()
          .forEach(
              (name, parsed) -> {
                Node node = named.get(parsed);
                if (node != null) {
                  scene.name(name, node);
                }
              });
      file.exports().forEach(export -> scene.exports().put(export.as(), export.localDef()));
      file.imports().forEach(this::importNode);
      for (X3dFile.ParsedRoute route : file.routes()) {
        Node from = named.get(route.from());
        Node to = named.get(route.to());
        if (from != null && to != null) {
          scene.addRoute(new Route(from, route.fromField(), to, route.toField()));
        }
      }
      return scene;
    }

    private void importNode(X3dFile.Import wanted) {
      Optional<Node> node =
          scene
              .find(wanted.inlineDef())
              .filter(InlineNode.class::isInstance)
              .flatMap(inline -> ((InlineNode) inline).content())
              .flatMap(
                  inner ->
                      Optional.ofNullable(inner.exports().get(wanted.importedDef()))
                          .flatMap(inner::find));
      if (node.isEmpty()) {
        problems.error(
            wanted.location(),
            "IMPORT finds no node exported as %s by Inline %s and is left out"
                .formatted(wanted.importedDef(), wanted.inlineDef()));
      } else {
        scene.imported().put(wanted.as(), node.get());
      }
    }

    private Optional<Node> make(ParsedNode parsed) {
      Node known = named.get(parsed);
      if (known != null) {
        return Optional.of(known);
      }
      if (++nodes > MAX_NODES) {
        if (nodes == MAX_NODES + 1) {
          problems.error(
              parsed.location(),
              "the scene has more than %d nodes; the rest is left out".formatted(MAX_NODES));
        }
        return Optional.empty();
      }
      Node node = factory.make(parsed.type(), parsed.name(), parsed.location());
      named.put(parsed, node);
      for (FieldDefinition field : parsed.type().fields()) {
        if (parsed.given(field.index())) {
          node.init(field.index(), convert(field, parsed));
        }
      }
      attach(parsed, node);
      return Optional.of(node);
    }

    private Object convert(FieldDefinition field, ParsedNode parsed) {
      Object value = parsed.value(field.index());
      if (field.type() == FieldType.SFNode) {
        return value instanceof ParsedNode child ? make(child).orElse(null) : null;
      }
      if (field.type() == FieldType.MFNode) {
        List<Node> children = new ArrayList<>();
        for (NodeView child : parsed.nodes(field.name())) {
          make((ParsedNode) child).ifPresent(children::add);
        }
        return List.copyOf(children);
      }
      return value;
    }

    private void attach(ParsedNode parsed, Node node) {
      Optional.ofNullable(content.meshes().get(parsed)).ifPresent(mesh -> assets.put(node, mesh));
      Optional.ofNullable(content.images().get(parsed))
          .ifPresent(image -> assets.putImage(node, image));
      if (node instanceof InlineNode inline) {
        Optional.ofNullable(content.inlines().get(parsed))
            .flatMap(FileContent.FileReference::content)
            .ifPresent(inner -> fill(inline, inner));
      }
      if (!factory.actsOn(node.type()) && keptOnly.add(node.type().name())) {
        problems.info(
            node.location(),
            "%s is kept in the scene; nothing is done with it yet".formatted(node.type().name()));
      }
    }

    private void fill(InlineNode inline, FileContent inner) {
      if (files.contains(inner.path())) {
        problems.error(
            inline.location(),
            "Inline %s includes itself and is left out".formatted(inner.file().source()));
        return;
      }
      Scene included = SceneBuilder.this.build(inner, files);
      inline.fill(included, included.unitLength() / scene.unitLength());
    }
  }
}
