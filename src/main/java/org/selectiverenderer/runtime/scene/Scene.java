package org.selectiverenderer.runtime.scene;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A scene: its nodes under one root group, names, routes, and the head of its file. The content of
 * an Inline is a scene of its own.
 */
public final class Scene {
  private final Node root;
  private final String url;
  private final String version;
  private final String profile;
  private final Map<String, Integer> components;
  private final Map<String, String> meta = new LinkedHashMap<>();
  private final double unitLength;
  private final Map<String, Node> named = new LinkedHashMap<>();
  private final Map<String, Node> imported = new LinkedHashMap<>();
  private final Map<String, String> exports = new LinkedHashMap<>();
  private final SceneImports imports = new SceneImports();
  private final Map<String, SceneImports.ExportedInstance> exportedInstances =
      new LinkedHashMap<>();
  private final Set<Route> routes = new LinkedHashSet<>();
  private @Nullable Set<String> types;
  private final Set<Node> loose = new LinkedHashSet<>();

  /**
   * @param root a Group that holds the scene's top nodes in its {@code children}
   * @param url where it was read, or empty
   * @param unitLength metres per unit of length
   */
  public Scene(
      Node root,
      String url,
      String version,
      String profile,
      Map<String, Integer> components,
      double unitLength) {
    this.root = root;
    this.url = url;
    this.version = version;
    this.profile = profile;
    this.components = Collections.unmodifiableMap(new LinkedHashMap<>(components));
    this.unitLength = unitLength;
  }

  /** The group that holds the top nodes; no part of the file. */
  public Node root() {
    return root;
  }

  public String url() {
    return url;
  }

  public String version() {
    return version;
  }

  public String profile() {
    return profile;
  }

  public Map<String, Integer> components() {
    return components;
  }

  /** The meta statements, name to content; may be changed. */
  public Map<String, String> meta() {
    return meta;
  }

  /** Metres per unit of length, from the {@code unit} statement. */
  public double unitLength() {
    return unitLength;
  }

  /** DEF name to node, in document order. */
  public Map<String, Node> named() {
    return Collections.unmodifiableMap(named);
  }

  public Optional<Node> find(String name) {
    return Optional.ofNullable(named.get(name));
  }

  /** Names a node, or gives a name to another node. */
  public void name(String name, Node node) {
    Node before = named.put(name, node);
    if (before != null && before != node && name.equals(before.name())) {
      before.rename(null);
    }
    node.rename(name);
  }

  /** Frees a name. A node that has another one besides keeps that. */
  public void unname(String name) {
    Node node = named.remove(name);
    if (node != null && name.equals(node.name())) {
      node.rename(null);
    }
  }

  /** Imported name to node, from IMPORT statements. */
  public Map<String, Node> imported() {
    return imported;
  }

  /** What this scene has from its Inlines. */
  public SceneImports imports() {
    return imports;
  }

  /** The node that is exported under a name: one of its own, or one that it imports itself. */
  public Optional<Node> exported(String name) {
    String local = exports.get(name);
    if (local == null) {
      return Optional.empty();
    }
    Node own = named.get(local);
    return Optional.ofNullable(own != null ? own : imported.get(local));
  }

  /** What the fields of an exported instance of a prototype stand for; empty for other nodes. */
  public Optional<SceneImports.ExportedInstance> exportedInstance(String name) {
    return Optional.ofNullable(exportedInstances.get(name));
  }

  public void exportInstance(String name, SceneImports.ExportedInstance fields) {
    exportedInstances.put(name, fields);
  }

  /** Exported name to DEF name, from EXPORT statements. */
  public Map<String, String> exports() {
    return exports;
  }

  /**
   * Nodes that stand in no other and take part by routes only, such as the clock of a prototype: of
   * a prototype's body only the first node takes the instance's place (X3D 4.0, 4.4.4.3).
   */
  public Set<Node> loose() {
    return Collections.unmodifiableSet(loose);
  }

  public void addLoose(Node node) {
    loose.add(node);
  }

  /** The names of the node types in its file; empty if that is not known. */
  public Optional<Set<String>> types() {
    return Optional.ofNullable(types).map(Collections::unmodifiableSet);
  }

  /**
   * Whether nodes can come that its file does not hold: by an application, a Script, an Inline, or
   * through what it exports. Nodes at its top are not meant.
   */
  public boolean mayGrow() {
    return types == null
        || !exports.isEmpty()
        || types.contains("Script")
        || types.contains("Inline");
  }

  /** Notes the names of the node types in its file. */
  public void types(Set<String> ofFile) {
    types = ofFile;
  }

  public List<Route> routes() {
    return List.copyOf(routes);
  }

  /** Adds a route unless the same one is there. */
  public void addRoute(Route route) {
    if (routes.add(route)) {
      route.from().addRoute(route);
    }
  }

  /** Removes a route; of a file's own, one between instances is several between their nodes. */
  public void removeRoute(Route route) {
    if (routes.remove(route)) {
      route.from().removeRoute(route);
      return;
    }
    for (Route behind : InstanceFace.behind(route)) {
      if (routes.remove(behind)) {
        behind.from().removeRoute(behind);
      }
    }
  }
}
