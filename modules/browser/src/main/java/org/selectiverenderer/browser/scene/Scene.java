package org.selectiverenderer.browser.scene;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A running scene: its nodes under one root group, DEF names, routes, and the head of its file. The
 * content of an Inline is a scene of its own.
 */
public final class Scene {
  private final Node root;
  private final String url;
  private final String version;
  private final String profile;
  private final Map<String, Integer> components;
  private final double unitLength;
  private final SceneImports imports = new SceneImports();

  // Each is a LinkedHashMap or LinkedHashSet from the first change on. Until then it is empty or
  // shared by the scenes of the same file, of which there may be tens of thousands.
  private Map<String, String> meta = Collections.emptyMap();
  private Map<String, Node> named = Collections.emptyMap();
  private Map<String, Node> imported = Collections.emptyMap();
  private Map<String, String> exports = Collections.emptyMap();
  private Map<String, SceneImports.ExportedInstance> exportedInstances = Collections.emptyMap();
  private Set<Route> routes = Collections.emptySet();
  private Set<Node> loose = Collections.emptySet();
  private @Nullable Set<String> types;
  private @Nullable Object companion;

  /**
   * @param root a Group that holds the scene's top nodes in its {@code children}
   * @param url the address from which the scene was read, or empty
   * @param components the levels of the components that the file names; never changed
   * @param unitLength the metres per unit of length
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
    this.components = Collections.unmodifiableMap(components);
    this.unitLength = unitLength;
  }

  /** Returns the group that holds the root nodes; it is no part of the file. */
  public Node root() {
    return root;
  }

  /** Returns the object that the loader has attached to this scene; null without one. */
  public @Nullable Object companion() {
    return companion;
  }

  public void companion(Object object) {
    companion = object;
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

  /** Returns the meta statements, name to content. */
  public Map<String, String> meta() {
    return Collections.unmodifiableMap(meta);
  }

  public void putMeta(String name, String content) {
    meta = own(meta);
    meta.put(name, content);
  }

  public void removeMeta(String name) {
    if (meta.containsKey(name)) {
      meta = own(meta);
      meta.remove(name);
    }
  }

  /**
   * Sets the meta statements and exports, which the scenes of one file share until one changes.
   *
   * @param itsMeta the meta statements, name to content; not to be changed
   * @param itsExports the exported names with their DEF names; not to be changed
   */
  public void head(Map<String, String> itsMeta, Map<String, String> itsExports) {
    meta = Collections.unmodifiableMap(itsMeta);
    exports = Collections.unmodifiableMap(itsExports);
  }

  private static <V> Map<String, V> own(Map<String, V> map) {
    return map instanceof LinkedHashMap ? map : new LinkedHashMap<>(map);
  }

  private static <T> Set<T> own(Set<T> set) {
    return set instanceof LinkedHashSet ? set : new LinkedHashSet<>(set);
  }

  /** Returns the metres per unit of length, from the {@code unit} statement. */
  public double unitLength() {
    return unitLength;
  }

  /** Returns the DEF names with their nodes, in document order. */
  public Map<String, Node> named() {
    return Collections.unmodifiableMap(named);
  }

  public Optional<Node> find(String name) {
    return Optional.ofNullable(named.get(name));
  }

  /**
   * Sets the DEF names of a file, which the scenes of the file share until one changes.
   *
   * @param places the place of each name's node, in document order; not to be changed
   * @param nodes the nodes; not to be changed
   */
  public void names(Map<String, Integer> places, Node[] nodes) {
    named = new NamesOfFile(places, nodes);
    places.forEach((name, place) -> nodes[place].rename(name));
  }

  /** Assigns a DEF name to a node; a name in use is moved to that node. */
  public void name(String name, Node node) {
    named = own(named);
    Node before = named.put(name, node);
    if (before != null && before != node && name.equals(before.name())) {
      before.rename(null);
    }
    node.rename(name);
  }

  /** Removes a DEF name. A node with a second name keeps that. */
  public void unname(String name) {
    Node node = named.get(name);
    if (node == null) {
      return;
    }
    named = own(named);
    named.remove(name);
    if (name.equals(node.name())) {
      node.rename(null);
    }
  }

  /** Returns the imported names with their nodes, from IMPORT statements. */
  public Map<String, Node> imported() {
    return Collections.unmodifiableMap(imported);
  }

  public void putImported(String name, Node node) {
    imported = own(imported);
    imported.put(name, node);
  }

  public void removeImported(String name) {
    if (imported.containsKey(name)) {
      imported.remove(name);
    }
  }

  /** Returns the imports from this scene's Inlines. */
  public SceneImports imports() {
    return imports;
  }

  /** Returns the node exported under a name: one of this scene, or one that it imports itself. */
  public Optional<Node> exported(String name) {
    String local = exports.get(name);
    if (local == null) {
      return Optional.empty();
    }
    Node own = named.get(local);
    return Optional.ofNullable(own != null ? own : imported.get(local));
  }

  /**
   * Returns the connections of the fields of an exported prototype instance; empty for other nodes.
   */
  public Optional<SceneImports.ExportedInstance> exportedInstance(String name) {
    return Optional.ofNullable(exportedInstances.get(name));
  }

  public void exportInstance(String name, SceneImports.ExportedInstance fields) {
    exportedInstances = own(exportedInstances);
    exportedInstances.put(name, fields);
  }

  /** Returns the exported names with their DEF names, from EXPORT statements. */
  public Map<String, String> exports() {
    return Collections.unmodifiableMap(exports);
  }

  /** Exports the node of a DEF name under a name. */
  public void putExport(String as, String localDef) {
    exports = own(exports);
    exports.put(as, localDef);
  }

  public void removeExport(String as) {
    if (exports.containsKey(as)) {
      exports = own(exports);
      exports.remove(as);
    }
  }

  /**
   * Returns the nodes outside the scene graph, which take part by routes only, such as the
   * TimeSensor of a prototype: of a prototype's body only the first node takes the instance's place
   * (X3D 4.0, 4.4.4.3).
   */
  public Set<Node> loose() {
    return Collections.unmodifiableSet(loose);
  }

  public void addLoose(Node node) {
    loose = own(loose);
    loose.add(node);
  }

  /** Returns the names of the node types in the file; empty if unknown. */
  public Optional<Set<String>> types() {
    return Optional.ofNullable(types).map(Collections::unmodifiableSet);
  }

  /**
   * Returns whether nodes that are not in the file can be added: by an application, a Script, an
   * Inline or through an export. Added root nodes do not count.
   */
  public boolean mayGrow() {
    return types == null
        || !exports.isEmpty()
        || types.contains("Script")
        || types.contains("Inline");
  }

  /** Sets the names of the node types in the file. */
  public void types(Set<String> ofFile) {
    types = ofFile;
  }

  public List<Route> routes() {
    return List.copyOf(routes);
  }

  /** Adds a route unless the scene has the same one. */
  public void addRoute(Route route) {
    routes = own(routes);
    if (routes.add(route)) {
      route.from().addRoute(route);
    }
  }

  /**
   * Removes a route; one between prototype instances stands for several between their body nodes.
   */
  public void removeRoute(Route route) {
    if (routes.contains(route)) {
      routes.remove(route);
      route.from().removeRoute(route);
      return;
    }
    for (Route behind : PrototypeInstance.behind(route)) {
      if (routes.contains(behind)) {
        routes.remove(behind);
        behind.from().removeRoute(behind);
      }
    }
  }
}
