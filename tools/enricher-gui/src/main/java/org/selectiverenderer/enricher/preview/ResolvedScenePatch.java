package org.selectiverenderer.enricher.preview;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
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

  private record Event(Node node, String field, @Nullable Object value) {}

  private final List<Event> events;
  private final Map<String, Node> names;

  private ResolvedScenePatch(List<Event> events, Map<String, Node> names) {
    this.events = events;
    this.names = names;
  }

  /** The parsed metadata nodes, one per owner and null for none, and their DEF names. */
  private record Read(List<@Nullable Node> nodes, Map<String, Node> names) {}

  /**
   * Resolves the nodes of a patch.
   *
   * @param loader the scene's loader, which parses the metadata
   * @return empty if a node is missing or of another type
   */
  static Optional<ResolvedScenePatch> of(
      ScenePatch patch, PreviewNodeIndex nodes, SceneLoader loader) {
    Set<Place> places = new HashSet<>();
    patch.fields().forEach(field -> places.add(field.place()));
    patch.metadata().forEach(metadata -> places.add(metadata.place()));
    Map<Place, Node> found = places.isEmpty() ? Map.of() : nodes.at(places);
    List<Event> events = new ArrayList<>();
    for (ScenePatch.Field field : patch.fields()) {
      Node node = found.get(field.place());
      if (node == null || !node.type().name().equals(field.type())) {
        return Optional.empty();
      }
      events.add(new Event(node, field.name(), field.value()));
    }
    Optional<Read> read = read(patch.metadata(), loader);
    for (int i = 0; i < patch.metadata().size(); i++) {
      ScenePatch.Metadata metadata = patch.metadata().get(i);
      Node node = found.get(metadata.place());
      if (node == null || read.isEmpty() || !node.type().name().equals(metadata.type())) {
        return Optional.empty();
      }
      events.add(new Event(node, METADATA, read.get().nodes().get(i)));
    }
    return Optional.of(new ResolvedScenePatch(events, read.map(Read::names).orElse(Map.of())));
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
    names.forEach(world.scene()::name);
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
