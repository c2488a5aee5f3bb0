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
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;

/** A {@link ScenePatch} with the nodes that it means: events to be sent to a running scene. */
final class RunningPatch {
  private record Event(Node node, String field, @Nullable Object value) {}

  private final List<Event> events;

  private RunningPatch(List<Event> events) {
    this.events = events;
  }

  /**
   * Finds the nodes.
   *
   * @param loader of the scene, which reads the metadata
   * @return empty if one is not there, or not what it should be
   */
  static Optional<RunningPatch> of(ScenePatch patch, PreviewNodes nodes, SceneLoader loader) {
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
    List<@Nullable Node> read = read(patch.metadata(), loader);
    for (int i = 0; i < patch.metadata().size(); i++) {
      ScenePatch.Metadata metadata = patch.metadata().get(i);
      Node node = found.get(metadata.place());
      if (node == null || read.isEmpty() || !node.type().name().equals(metadata.type())) {
        return Optional.empty();
      }
      events.add(new Event(node, "metadata", read.get(i)));
    }
    return Optional.of(new RunningPatch(events));
  }

  /** The metadata nodes, null where there are none; an empty list if they cannot be read. */
  private static List<@Nullable Node> read(List<ScenePatch.Metadata> texts, SceneLoader loader) {
    StringBuilder scene = new StringBuilder("<X3D version='4.0'><Scene>");
    texts.forEach(each -> scene.append("<Group>").append(each.text()).append("</Group>"));
    byte[] bytes = scene.append("</Scene></X3D>").toString().getBytes(StandardCharsets.UTF_8);
    Problems problems = new Problems(); // The document's own checks tell them.
    try {
      List<Node> owners =
          loader
              .load("metadata", new ByteArrayInputStream(bytes), Path.of(""), problems)
              .scene()
              .root()
              .nodes("children");
      List<@Nullable Node> read = new ArrayList<>();
      owners.forEach(owner -> read.add(owner.node("metadata")));
      return owners.size() == texts.size() ? read : List.of();
    } catch (IOException e) {
      return List.of();
    }
  }

  void apply(Cascade cascade) {
    for (Event event : events) {
      cascade.send(event.node(), event.node().type().indexOf(event.field()), event.value());
    }
    cascade.run();
  }
}
