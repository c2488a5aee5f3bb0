package org.selectiverenderer.browser.sai;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ImportedNodeException;
import org.web3d.x3d.sai.InvalidExecutionContextException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DRoute;

/**
 * The SAI's scene object. Until the scene is shown, changes are done at once, by any thread. From
 * then on changes of nodes and routes go through the world as writes of fields do.
 */
final class EmbeddedScene extends PrototypelessSceneAdapter {
  private final SaiContext binding;
  private final SceneFactory maker;
  private final Scene scene;
  private final @Nullable String worldUrl;
  private volatile boolean shown;
  private volatile boolean disposed;

  /**
   * @param scene the scene, whose lock is held while its lists of names are read or written
   * @param worldUrl the scene's full URL, or empty; null for that of the file it was read from
   */
  EmbeddedScene(SaiContext binding, SceneFactory maker, Scene scene, @Nullable String worldUrl) {
    this.binding = binding;
    this.maker = maker;
    this.scene = scene;
    this.worldUrl = worldUrl;
  }

  SaiContext binding() {
    return binding;
  }

  Scene scene() {
    check();
    return scene;
  }

  boolean isOf(Scene other) {
    return scene == other;
  }

  /** Notes that the world is about to show the scene. */
  void show() {
    shown = true;
  }

  @Override
  void check() {
    binding.check();
    if (disposed) {
      throw new InvalidExecutionContextException("the scene is disposed of");
    }
  }

  /** Changes routes or nodes: through the world if it shows the scene. */
  private void change(Runnable change) {
    if (shown) {
      binding.execute(() -> locked(change));
    } else {
      locked(change);
    }
  }

  private void locked(Runnable change) {
    synchronized (scene) {
      change.run();
    }
  }

  private <T> T read(Supplier<T> reading) {
    check();
    synchronized (scene) {
      return reading.get();
    }
  }

  private void write(Runnable change) {
    check();
    locked(change);
  }

  @Override
  public String getSpecificationVersion() {
    check();
    return scene.version();
  }

  @Override
  public int getEncoding() {
    check();
    return scene.url().isEmpty() ? SCRIPTED_ENCODING : XML_ENCODING;
  }

  @Override
  public @Nullable ProfileInfo getProfile() {
    check();
    return maker.profile(scene.profile());
  }

  @Override
  public ComponentInfo[] getComponents() {
    check();
    return BrowserCapabilities.components(scene.components());
  }

  @Override
  public String getWorldURL() {
    check();
    return worldUrl != null ? worldUrl : SaiUrls.urlOf(scene.url());
  }

  @Override
  public X3DRoute[] getRoutes() {
    return read(
        () ->
            scene.routes().stream()
                .map(route -> new EmbeddedRoute(binding, route))
                .toArray(X3DRoute[]::new));
  }

  @Override
  public X3DRoute addRoute(
      X3DNode fromNode, String readableField, X3DNode toNode, String writableField) {
    check();
    Route route =
        RouteValidator.between(
            binding.unwrapped(fromNode), readableField, binding.unwrapped(toNode), writableField);
    change(() -> scene.addRoute(route));
    return new EmbeddedRoute(binding, route);
  }

  @Override
  public void removeRoute(X3DRoute route) {
    check();
    if (route instanceof EmbeddedRoute embedded) {
      change(() -> scene.removeRoute(embedded.route()));
    }
  }

  @Override
  public String[] getNamedNodes() {
    return read(() -> scene.named().keySet().toArray(String[]::new));
  }

  @Override
  public X3DNode getNamedNode(String name) {
    return read(
        () ->
            binding.wrapped(
                scene
                    .find(name)
                    .or(() -> Optional.ofNullable(scene.imported().get(name)))
                    .orElseThrow(
                        () -> new InvalidNodeException("no node has the DEF name " + name))));
  }

  /** Returns the DEF names in this scene of those of some nodes that have one. */
  Map<X3DNode, String> namesOf(Set<X3DNode> nodes) {
    return read(
        () -> {
          Map<X3DNode, String> names = new HashMap<>();
          Set<X3DNode> rest = nodes.size() < scene.named().size() ? direct(nodes, names) : nodes;
          if (!rest.isEmpty()) {
            scene
                .named()
                .forEach(
                    (name, node) ->
                        binding
                            .known(PrototypeInstance.body(PrototypeInstance.seen(node, null)))
                            .filter(rest::contains)
                            .ifPresent(known -> names.put(known, name)));
          }
          return names;
        });
  }

  /** Adds the names that nodes know themselves, and returns the nodes that may have another one. */
  private Set<X3DNode> direct(Set<X3DNode> nodes, Map<X3DNode, String> names) {
    Set<X3DNode> rest = new HashSet<>();
    for (X3DNode known : nodes) {
      Node node = binding.own(known).orElse(null);
      String name = node == null ? null : node.name();
      if (name != null
          && PrototypeInstance.seen(node, null) == node
          && scene.find(name).orElse(null) == node) {
        names.put(known, name);
      } else {
        rest.add(known);
      }
    }
    return rest;
  }

  @Override
  public void updateNamedNode(String name, X3DNode node) {
    check();
    Node named = binding.body(node);
    write(
        () -> {
          if (scene.imported().containsKey(name)) {
            throw new ImportedNodeException(name + " is the name of an imported node");
          }
          scene.name(name, named);
        });
  }

  @Override
  public void removeNamedNode(String name) {
    write(() -> scene.unname(name));
  }

  @Override
  public X3DNode getImportedNode(String name) {
    return read(
        () -> {
          Node node = scene.imported().get(name);
          if (node == null) {
            throw new InvalidNodeException("no node is imported as " + name);
          }
          return binding.wrapped(node);
        });
  }

  @Override
  public void removeImportedNode(String name) {
    write(() -> scene.removeImported(name));
  }

  @Override
  public void updateImportedNode(String exportedName, String name, X3DNode inline) {
    check();
    Node node =
        Optional.of(binding.body(inline))
            .filter(InlineNode.class::isInstance)
            .flatMap(candidate -> ((InlineNode) candidate).content())
            .flatMap(inner -> inner.exported(exportedName))
            .orElseThrow(
                () -> new ImportedNodeException("the Inline exports no node as " + exportedName));
    write(() -> scene.putImported(name, node));
  }

  @Override
  public X3DNode getExportedNode(String name) {
    return read(
        () ->
            binding.wrapped(
                scene
                    .exported(name)
                    .orElseThrow(
                        () -> new InvalidNodeException("no node is exported as " + name))));
  }

  @Override
  public String[] getExportedNodes() {
    return read(() -> scene.exports().keySet().toArray(String[]::new));
  }

  @Override
  public void updateExportedNode(String name, @Nullable String exportedName) {
    write(
        () -> {
          if (scene.find(name).isEmpty()) {
            throw new InvalidNodeException("no node has the DEF name " + name);
          }
          scene.putExport(exportedName == null ? name : exportedName, name);
        });
  }

  @Override
  public void removeExportedNode(String exportedName) {
    write(() -> scene.removeExport(exportedName));
  }

  @Override
  public void addMetaData(String name, String value) {
    write(() -> scene.putMeta(name, value));
  }

  @Override
  public Map<String, String> getMetaData() {
    return read(() -> new LinkedHashMap<>(scene.meta()));
  }

  @Override
  public void removeMetaData(String name) {
    write(() -> scene.removeMeta(name));
  }

  @Override
  public X3DNode createNode(String name) {
    check();
    return maker
        .node(name)
        .orElseThrow(() -> new InvalidNodeException("there is no node type " + name));
  }

  @Override
  public X3DNode[] getRootNodes() {
    return read(
        () ->
            scene.root().nodes("children").stream().map(binding::wrapped).toArray(X3DNode[]::new));
  }

  @Override
  public void addRootNode(X3DNode node) {
    check();
    Node added = binding.body(node);
    changeRoots(roots -> roots.add(added));
  }

  @Override
  public void removeRootNode(X3DNode node) {
    check();
    Node removed = binding.body(node);
    changeRoots(roots -> roots.remove(removed));
  }

  private void changeRoots(Predicate<List<Node>> change) {
    change(
        () -> {
          List<Node> roots = new ArrayList<>(scene.root().nodes("children"));
          if (!change.test(roots)) {
            return;
          }
          if (shown) {
            binding.sendNow(scene.root(), children(), List.copyOf(roots));
          } else {
            scene.root().init(children(), List.copyOf(roots));
          }
        });
  }

  private int children() {
    return scene.root().type().indexOf("children");
  }

  @Override
  public void dispose() {
    disposed = true;
  }

  /** Two objects of one scene are equal. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof EmbeddedScene same && same.scene == scene;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(scene);
  }

  /** Checks and makes the routes that an application adds (X3D 4.0, 4.4.8.2). */
  private static final class RouteValidator {
    private RouteValidator() {}

    /**
     * Returns a route between two fields, given by the names of the fields or of their events.
     *
     * @throws InvalidReadableFieldException if the first field sends no events
     * @throws InvalidWritableFieldException if the second receives none, or of another type
     */
    static Route between(Node from, String readableField, Node to, String writableField) {
      FieldDefinition out =
          from.type()
              .output(readableField)
              .orElseThrow(
                  () ->
                      new InvalidReadableFieldException(
                          from + " has no output field " + readableField));
      FieldDefinition in =
          to.type()
              .input(writableField)
              .orElseThrow(
                  () ->
                      new InvalidWritableFieldException(
                          to + " has no input field " + writableField));
      if (out.type() != in.type()) {
        throw new InvalidWritableFieldException(
            "%s of %s cannot be routed to %s of %s: the types %s and %s differ"
                .formatted(out.name(), from, in.name(), to, out.type(), in.type()));
      }
      return new Route(from, out.index(), to, in.index());
    }
  }
}
