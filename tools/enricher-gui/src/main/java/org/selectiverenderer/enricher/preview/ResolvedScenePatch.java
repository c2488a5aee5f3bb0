package org.selectiverenderer.enricher.preview;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;

/**
 * A {@link ScenePatch} with its positions resolved to nodes of a running scene, as events to be
 * sent.
 */
final class ResolvedScenePatch {
  private static final String METADATA = "metadata";
  private static final String CHILDREN = "children";

  private record Event(Node node, String field, @Nullable Object value) {}

  private final List<Event> events;
  private final Map<String, Node> names;
  private final List<String> unnamed;
  private final Set<String> types;

  private ResolvedScenePatch(
      List<Event> events, Map<String, Node> names, List<String> unnamed, Set<String> types) {
    this.events = events;
    this.names = names;
    this.unnamed = unnamed;
    this.types = types;
  }

  /** The parsed metadata nodes, one per owner and null for none, and their DEF names. */
  private record Read(List<@Nullable Node> nodes, Map<String, Node> names) {}

  /**
   * Resolves the nodes of a patch.
   *
   * @param root the root node of the scene
   * @param loader the scene's loader, which parses the metadata
   * @param added the new nodes of the patch
   * @return empty if a node is missing or of another type
   */
  static Optional<ResolvedScenePatch> of(
      ScenePatch patch, PreviewNodeIndex nodes, Node root, SceneLoader loader, AddedNodes added) {
    Set<Place> places = new HashSet<>();
    patch.fields().forEach(field -> places.add(field.place()));
    patch.metadata().forEach(metadata -> places.add(metadata.place()));
    patch.names().forEach(name -> places.add(name.place()));
    for (ScenePatch.Children children : patch.children()) {
      children.owner().ifPresent(places::add);
      children.sibling().ifPresent(places::add);
      places.addAll(children.removed());
    }
    Map<Place, Node> found = places.isEmpty() ? Map.of() : nodes.at(places);
    List<Event> events = new ArrayList<>();
    for (ScenePatch.Field field : patch.fields()) {
      Node node = found.get(field.place());
      if (node == null || !node.type().name().equals(field.type())) {
        return Optional.empty();
      }
      events.add(new Event(node, field.name(), field.value()));
    }
    Optional<Read> parsed =
        patch.metadata().isEmpty() ? Optional.empty() : read(patch.metadata(), loader);
    for (int i = 0; i < patch.metadata().size(); i++) {
      ScenePatch.Metadata metadata = patch.metadata().get(i);
      Node node = found.get(metadata.place());
      if (node == null || parsed.isEmpty() || !node.type().name().equals(metadata.type())) {
        return Optional.empty();
      }
      events.add(new Event(node, METADATA, parsed.get().nodes().get(i)));
    }
    Map<String, Node> names = new LinkedHashMap<>(parsed.map(Read::names).orElse(Map.of()));
    List<String> unnamed = new ArrayList<>();
    for (ScenePatch.Name name : patch.names()) {
      Node node = found.get(name.place());
      if (node == null || !node.type().name().equals(name.type())) {
        return Optional.empty();
      }
      name.was().ifPresent(unnamed::add);
      name.is().ifPresent(now -> names.put(now, node));
    }
    Set<String> types = new HashSet<>();
    for (int i = 0; i < patch.children().size(); i++) {
      ScenePatch.Children children = patch.children().get(i);
      Node owner = children.owner().map(found::get).orElse(root);
      Optional<Node> sibling =
          children
              .sibling()
              .flatMap(at -> Optional.ofNullable(found.get(at)).or(() -> nodes.standing(at)));
      Optional<Scene> read = added.scenes().get(i);
      Optional<List<Node>> now =
          read.flatMap(
              scene -> children(owner, children, found, sibling, scene.root().nodes(CHILDREN)));
      if (now.isEmpty()) {
        return Optional.empty();
      }
      events.add(new Event(owner, CHILDREN, now.get()));
      unnamed.addAll(children.unnamed());
      names.putAll(read.get().named());
      read.get().types().ifPresent(types::addAll);
    }
    return Optional.of(new ResolvedScenePatch(events, names, unnamed, types));
  }

  /** Returns the children that a group has after the patch; empty if it has others before. */
  private static Optional<List<Node>> children(
      @Nullable Node owner,
      ScenePatch.Children children,
      Map<Place, Node> found,
      Optional<Node> sibling,
      List<Node> added) {
    boolean root = children.owner().isEmpty();
    if (owner == null || !root && !owner.type().name().equals(children.type())) {
      return Optional.empty();
    }
    List<Node> now = new ArrayList<>(owner.nodes(CHILDREN));
    for (Place place : children.removed()) {
      Node gone = found.get(place);
      if (gone == null || !now.remove(gone) || now.contains(gone)) {
        return Optional.empty();
      }
    }
    int index = 0;
    if (children.sibling().isPresent()) {
      index = sibling.map(now::lastIndexOf).orElse(-1) + 1;
      if (index == 0) {
        return Optional.empty();
      }
    }
    now.addAll(index, added);
    return Optional.of(List.copyOf(now));
  }

  private static Optional<Read> read(List<ScenePatch.Metadata> texts, SceneLoader loader) {
    StringBuilder scene = new StringBuilder("<X3D version='4.0'><Scene>");
    texts.forEach(each -> scene.append("<Group>").append(each.text()).append("</Group>"));
    byte[] bytes = scene.append("</Scene></X3D>").toString().getBytes(StandardCharsets.UTF_8);
    ProblemCollector problems = new ProblemCollector(); // The document's own checks report them.
    try {
      Scene read =
          loader.load(METADATA, new ByteArrayInputStream(bytes), Path.of(""), problems).scene();
      List<Node> owners = read.root().nodes("children");
      List<@Nullable Node> nodes = new ArrayList<>();
      owners.forEach(owner -> nodes.add(owner.node(METADATA)));
      return owners.size() == texts.size()
          ? Optional.of(new Read(nodes, Map.copyOf(read.named())))
          : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  void apply(World world) {
    EventCascade cascade = world.cascade();
    for (Event event : events) {
      if (event.field().equals(METADATA)) {
        unname(event.node().node(METADATA), world.scene());
      }
      cascade.send(event.node(), event.node().type().indexOf(event.field()), event.value());
    }
    unnamed.forEach(world.scene()::unname);
    names.forEach(world.scene()::name);
    Set<String> all = new HashSet<>(world.scene().types().orElse(Set.of()));
    if (world.scene().types().isPresent() && all.addAll(types)) {
      world.scene().types(all);
    }
    cascade.run();
  }

  private static void unname(@Nullable Node metadata, Scene scene) {
    if (metadata == null) {
      return;
    }
    String name = metadata.name();
    if (name != null && scene.find(name).filter(found -> found == metadata).isPresent()) {
      scene.unname(name);
    }
    if (metadata.type().name().equals("MetadataSet")) {
      metadata.nodes("value").forEach(value -> unname(value, scene));
    }
  }
}
