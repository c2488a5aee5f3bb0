package org.selectiverenderer.models.gltf.write;

import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads the scenes of Inlines, each once, so that all Inlines of it share its meshes, and refuses
 * those that contain themselves.
 */
final class GltfInlineReader {
  private final X3dReader reader;
  private final UrlResolver root;
  private final PrototypeLibraryLoader libraries;
  private final GltfLosses losses;
  private final GltfAnimationWriter animations;
  private final Map<String, X3dFile> files = new HashMap<>();
  private final Set<String> open = new HashSet<>();

  GltfInlineReader(
      X3dReader reader, UrlResolver root, GltfLosses losses, GltfAnimationWriter animations) {
    this.reader = reader;
    this.root = root;
    this.losses = losses;
    this.animations = animations;
    libraries = new PrototypeLibraryLoader(reader, root);
  }

  /**
   * Returns the place of the nodes in an Inline, which {@link #leave} ends; empty if it shows
   * nothing, for a reason that is reported.
   */
  Optional<GltfPlace> enter(NodeView inline, GltfPlace place) {
    if (!inline.bool("load")) {
      losses.tell("load", inline.location(), "an Inline with load FALSE is left out");
      return Optional.empty();
    }
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(inline, root, place.base(inline), "the Inline is left out");
    if (!(choice instanceof ResolvedUrlContent.Found found)) {
      losses.problems().add(((ResolvedUrlContent.None) choice).problem());
      return Optional.empty();
    }
    UrlContent content = found.content();
    if (open.contains(content.key())) {
      losses
          .problems()
          .error(inline.location(), "the Inline names a file that contains it; it is left out");
      return Optional.empty();
    }
    Optional<X3dFile> file = read(inline, content);
    if (file.isPresent()) {
      open.add(content.key());
    }
    return file.map(
        read ->
            new GltfPlace(read, content.key(), content.base(), place.depth() + 1, place.scale()));
  }

  /** Ends what {@link #enter} began. */
  void leave(GltfPlace inside) {
    open.remove(inside.key());
  }

  private Optional<X3dFile> read(NodeView inline, UrlContent content) {
    X3dFile known = files.get(content.key());
    if (known == null) {
      try (InputStream in = content.open()) {
        known =
            reader
                .with(libraries, content.base())
                .read(content.name(), in, content.size(), losses.problems());
      } catch (IOException e) {
        losses
            .problems()
            .error(
                inline.location(),
                "%s cannot be read (%s); the Inline is left out"
                    .formatted(content.name(), e.getMessage()));
        return Optional.empty();
      }
      files.put(content.key(), known);
      animations.find(known);
    }
    return Optional.of(known);
  }
}
