package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.loading.LoadedFile.Outcome;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.geospatial.GeoLodNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sound.AudioClipNode;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeTemplate;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.geodesy.SpatialReferenceSystem;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Makes running scenes from parsed files and fills Inlines with scenes of their own. A builder
 * serves one load.
 */
final class SceneBuilder {
  /** Largest nesting depth of nodes, including those of Inlines. */
  static final int MAX_DEPTH = 1000;

  /** Largest nesting depth of Inlines. */
  static final int MAX_INLINES = 100;

  /** Cost of the scene of an Inline besides its nodes, counted in nodes. */
  private static final int SCENE_COST = 30;

  private final NodeFactory factory;
  private final NodeType groupType;
  private final NodeType inlineType;
  private final NodeRegistry store;
  private final UrlResolver root;
  private final int maxNodes;
  private final List<LoadedFile> files = new ArrayList<>();
  private final Map<LoadedFile, SharedHead> known = new IdentityHashMap<>();

  /** The location of the first Inline that names a file. */
  private final Map<LoadedFile, SourceLocation> references = new IdentityHashMap<>();

  private int nodes;
  private boolean tooMany;
  private int depth;

  /**
   * @param maxNodes the largest number of nodes; the rest is left out, so that Inlines cannot
   *     multiply without bound
   */
  SceneBuilder(
      NodeFactory factory,
      NodeType groupType,
      NodeType inlineType,
      NodeRegistry store,
      UrlResolver root,
      int maxNodes) {
    this.factory = factory;
    this.groupType = groupType;
    this.inlineType = inlineType;
    this.store = store;
    this.root = root;
    this.maxNodes = maxNodes;
  }

  /**
   * @param above the keys of the files that inline this one, outermost first
   */
  Scene build(LoadedFile content, List<String> above) {
    SharedHead head = known.get(content);
    if (head == null) {
      head = new SharedHead(content);
      known.put(content, head);
      files.add(content);
    }
    return new FileBuilder(content, head, above).build();
  }

  /** Reports the problems of all files built, in the order of their first use. */
  void report(ProblemCollector to) {
    for (LoadedFile content : files) {
      List<Problem> problems = content.problems().list();
      SourceLocation inline = references.get(content);
      (inline == null ? problems : Problem.withReference(problems, "Inline", inline))
          .forEach(to::add);
    }
  }

  /**
   * The facts that are found once for all nodes that are made from one parsed node.
   *
   * @param template the template of a Shape or geometry node
   * @param attached whether more belongs to the node than its values: a file, an image, a program
   * @param parts the nodes in a Shape; null for other nodes
   */
  private record Recipe(
      @Nullable NodeTemplate template, boolean attached, DeferredParts.@Nullable OfShape parts) {}

  /** The facts that all scenes of one file share, besides the values of its nodes. */
  private final class SharedHead implements DeferredParts.FirstCopy {
    private final LoadedFile content;
    private final DeferredParts deferred;

    final Map<ParsedNode, Recipe> recipes = new IdentityHashMap<>();

    /** The number of nodes in the scene last built, of which most are alike. */
    int count;

    final Map<String, Integer> components;
    final Map<String, String> meta;
    final Map<String, String> exports;

    /** The place of each DEF name in the file. */
    final Map<String, Integer> names = new LinkedHashMap<>();

    private @Nullable List<String> includedBy;
    private @Nullable UrlContext origin;

    SharedHead(LoadedFile content) {
      this.content = content;
      X3dFile file = content.file();
      deferred = new DeferredParts(factory, file);
      components = Collections.unmodifiableMap(new LinkedHashMap<>(file.components()));
      Map<String, String> named = new LinkedHashMap<>();
      file.meta().forEach(one -> named.put(one.name(), one.content()));
      meta = Collections.unmodifiableMap(named);
      Map<String, String> exported = new LinkedHashMap<>();
      file.exports().forEach(export -> exported.put(export.as(), export.localDef()));
      exports = Collections.unmodifiableMap(exported);
      file.named().keySet().forEach(name -> names.put(name, names.size()));
    }

    /** Returns the recipe of a node of the file; at the first time it reports the node's type. */
    Recipe recipe(ParsedNode parsed) {
      Recipe known = recipes.get(parsed);
      if (known == null) {
        known = newRecipe(parsed);
        recipes.put(parsed, known);
      }
      return known;
    }

    private Recipe newRecipe(ParsedNode parsed) {
      NodeType type = parsed.type();
      store.kept(type).ifPresent(text -> content.info(parsed.location(), text));
      Optional<Mesh> mesh = content.meshes().get(parsed);
      boolean attached =
          type.is("X3DUrlObject")
              || type.is("X3DTextureNode")
              || type.name().equals("Inline")
              || type.component().equals("Geospatial")
              || BackgroundTextures.names(type)
              || content.images().containsKey(parsed);
      if (type.name().equals("Shape")) {
        DeferredParts.OfShape parts = deferred.new OfShape(parsed, this);
        return new Recipe(new NodeTemplate(parsed.location(), mesh, parts), attached, parts);
      }
      return new Recipe(
          mesh == null ? null : new NodeTemplate(parsed.location(), mesh), attached, null);
    }

    @Override
    public boolean attached(ParsedNode parsed) {
      Recipe known = recipes.get(parsed);
      return known == null || known.attached();
    }

    @Override
    public @Nullable NodeTemplate template(ParsedNode parsed) {
      Recipe known = recipes.get(parsed);
      return known == null ? null : known.template();
    }

    /** Returns the context of the file's urls where it is inlined by some other files. */
    UrlContext origin(List<String> above) {
      if (origin == null || includedBy != above) {
        List<String> including = new ArrayList<>(above);
        including.add(content.key());
        origin =
            new UrlContext(
                root, content.base(), List.copyOf(including), content.file().unitLength());
        includedBy = above;
      }
      return origin;
    }
  }

  /** Builds the scene of one file, with its own DEF names and routes. */
  private final class FileBuilder {
    private final LoadedFile content;
    private final SharedHead head;
    private final UrlContext origin;
    private final boolean modern;
    private final Scene scene;
    private final Map<ParsedNode, Node> made;

    FileBuilder(LoadedFile content, SharedHead head, List<String> above) {
      this.content = content;
      this.head = head;
      X3dFile file = content.file();
      modern = file.version().startsWith("4");
      // A capacity for which the map hardly ever grows.
      made = new IdentityHashMap<>(head.count > 0 ? head.count : 4 * file.named().size() + 32);
      origin = head.origin(above);
      Node top = factory.make(groupType, null, SourceLocation.of(file.source()));
      scene =
          new Scene(
              top,
              file.source(),
              file.version(),
              file.profile(),
              head.components,
              origin.unitLength());
      scene.companion(origin);
    }

    Scene build() {
      X3dFile file = content.file();
      scene.root().init(groupType.indexOf("children"), makeAll(file.nodes()));
      file.loose().forEach(this::end);
      scene.head(head.meta, head.exports);
      scene.types(content.types());
      if (file.prototypes() != null && content.types().contains("Script")) {
        store.prototypes(scene.root(), file.prototypes());
      }
      if (!file.named().isEmpty()) {
        name(file.named());
      }
      for (X3dFile.ParsedRoute route : file.routes()) {
        Optional<Node> from = end(route.from());
        Optional<Node> to = end(route.to());
        if (from.isPresent() && to.isPresent()) {
          scene.addRoute(new Route(from.get(), route.fromField(), to.get(), route.toField()));
        }
      }
      PrototypeInstanceBuilder.build(file.instances(), made);
      new ImportBuilder(scene, this::end).build(file);
      scene.imports().refresh(scene, ImportUpdater::content, content::error);
      head.count = made.size();
      return scene;
    }

    private void name(Map<String, ParsedNode> named) {
      Node[] nodes = new Node[named.size()];
      int count = 0;
      for (ParsedNode parsed : named.values()) {
        Node node = made.get(parsed);
        if (node != null) {
          nodes[count++] = node;
        }
      }
      if (count == nodes.length) {
        scene.names(head.names, nodes);
        return;
      }
      named.forEach( // Some were left out.
          (name, parsed) -> {
            Node node = made.get(parsed);
            if (node != null) {
              scene.name(name, node);
            }
          });
    }

    /**
     * Returns the node at an end of a route; a node outside the scene graph is made for the route.
     */
    private Optional<Node> end(ParsedNode parsed) {
      Node known = made.get(parsed);
      if (known != null) {
        return Optional.of(known);
      }
      Optional<Node> loose = make(parsed);
      loose.ifPresent(scene::addLoose);
      content.types().add(parsed.type().name());
      return loose;
    }

    private Optional<Node> make(ParsedNode parsed) {
      Node known = made.get(parsed);
      if (known != null) {
        return Optional.of(known);
      }
      if (!affordable(parsed)) {
        return Optional.empty();
      }
      depth++;
      Node node = factory.make(parsed.type(), parsed.name(), parsed.location());
      made.put(parsed, node);
      node.init(deferred(parsed) ? parsed.values() : values(parsed));
      Recipe recipe = head.recipe(parsed);
      if (recipe.template() != null) {
        node.template(recipe.template());
      }
      if (recipe.attached()) {
        attach(parsed, node);
      }
      depth--;
      return Optional.of(node);
    }

    /** Returns whether the nodes in a node are made later, and then counts them now. */
    private boolean deferred(ParsedNode parsed) {
      Recipe before = head.recipes.get(parsed);
      if (before == null || before.parts() == null) {
        return false;
      }
      int count = before.parts().count(head);
      if (count <= 0 || nodes + count > maxNodes || depth + before.parts().height() > MAX_DEPTH) {
        return false; // What is left out is told of each node.
      }
      nodes += count;
      return true;
    }

    private boolean affordable(ParsedNode parsed) {
      if (depth >= MAX_DEPTH) {
        content.error(
            parsed.location(),
            "nodes and Inlines are nested more than %s deep; the %s is left out"
                .formatted(MAX_DEPTH, parsed.type().name()));
        return false;
      }
      nodes += parsed.type().name().equals("Inline") ? SCENE_COST : 1;
      if (nodes > maxNodes && !tooMany) {
        tooMany = true;
        content.error(
            parsed.location(),
            ("with its Inlines the scene has more than %s nodes (an Inline counts as "
                    + "%s); the rest is left out")
                .formatted(maxNodes, SCENE_COST));
      }
      return !tooMany;
    }

    private List<Node> makeAll(List<?> parsed) {
      List<Node> made = new ArrayList<>(parsed.size());
      for (Object node : parsed) {
        make((ParsedNode) node).ifPresent(made::add);
      }
      return List.copyOf(made);
    }

    /** Returns a node's values: the array of the parsed node itself if it holds no other nodes. */
    private @Nullable Object[] values(ParsedNode parsed) {
      List<FieldDefinition> fields = parsed.type().fields();
      @Nullable Object[] shared = parsed.values();
      @Nullable Object[] values = shared;
      for (int i = 0; i < shared.length; i++) {
        if (shared[i] == null) {
          continue;
        }
        FieldType type = fields.get(i).type();
        if (type == FieldType.SFNode || type == FieldType.MFNode) {
          values = values == shared ? shared.clone() : values;
          values[i] =
              shared[i] instanceof List<?> children
                  ? makeAll(children)
                  : make((ParsedNode) shared[i]).orElse(null);
        }
      }
      return values;
    }

    private void attach(ParsedNode parsed, Node node) {
      Optional.ofNullable(content.images().get(parsed))
          .ifPresent(image -> store.assets().putImage(node, image));
      if (node instanceof InlineNode inline) {
        store.origin(inline, origin.of(parsed));
        if (inline.bool("load")) {
          inline.asked(inline.strings("url"));
        }
        Optional.ofNullable(content.inlines().get(parsed))
            .ifPresent(outcome -> fill(inline, outcome.join()));
      } else if (node.type().is("X3DUrlObject")) {
        store.origin(node, origin.of(parsed));
        ScriptProgram program = content.programs().get(parsed);
        if (node instanceof ScriptNode script && program != null) {
          script.load(program, scene);
        }
        Optional.ofNullable(content.shaders().get(parsed))
            .ifPresent(text -> store.assets().putShader(node, text));
        AudioBuffer recording = content.sounds().get(parsed);
        if (node instanceof AudioClipNode clip && recording != null) {
          clip.recording(recording);
        } else if (node instanceof MovieTextureNode movie && recording != null) {
          movie.soundtrack(recording);
        }
      } else if (node.type().component().equals("Geospatial")) {
        geospatial(node, origin.of(parsed));
      }
      if (BackgroundTextures.names(node.type())) {
        store.origin(node, origin.of(parsed));
        content
            .pictures()
            .getOrDefault(parsed, Map.of())
            .forEach((side, one) -> make(one).ifPresent(made -> store.picture(node, side, made)));
      }
      if (modern && node.type().is("X3DTextureNode")) {
        store.assets().multiply(node);
      }
    }

    private void geospatial(Node node, UrlContext base) {
      if (node instanceof GeoLodNode level) {
        level.files(
            level.nodes("rootNode").isEmpty() ? inlines(level, base, "rootUrl") : List.of(),
            inlines(level, base, "child1Url", "child2Url", "child3Url", "child4Url"));
      }
      boolean tessellated =
          node.type().is("X3DGeometricPropertyNode") || node.type().is("X3DGeometryNode");
      if (!tessellated && node.type().field("geoSystem").isPresent()) {
        SpatialReferenceSystem.of(node.strings("geoSystem"))
            .problem()
            .ifPresent(text -> content.warning(node.location(), node.type().name() + " " + text));
      }
    }

    /** Makes an unloaded Inline for each url field that is not empty. */
    private List<InlineNode> inlines(Node node, UrlContext base, String... urls) {
      List<InlineNode> made = new ArrayList<>();
      for (String url : urls) {
        if (node.strings(url).length > 0) {
          InlineNode inline = (InlineNode) factory.make(inlineType, null, node.location());
          inline.init(inline.urlField(), node.strings(url));
          inline.init(inlineType.indexOf("load"), false);
          store.origin(inline, base);
          made.add(inline);
        }
      }
      return made;
    }

    private void fill(InlineNode inline, Outcome outcome) {
      if (outcome instanceof Outcome.Failed failed) {
        content.error(inline.location(), failed.sentence() + "; the Inline is left out");
        return;
      }
      LoadedFile inner = ((Outcome.Read) outcome).content();
      String name = inner.file().source();
      if (origin.including().contains(inner.key())) {
        content.error(
            inline.location(), "%s includes itself; the Inline is left out".formatted(name));
      } else if (origin.including().size() > MAX_INLINES) {
        content.error(
            inline.location(),
            "Inlines are nested more than %s deep; the Inline of %s is left out"
                .formatted(MAX_INLINES, name));
      } else {
        if (!known.containsKey(inner)) {
          references.put(inner, inline.location());
        }
        Scene included = SceneBuilder.this.build(inner, origin.including());
        inline.fill(included, included.unitLength() / scene.unitLength());
      }
    }
  }
}
