package org.selectiverenderer.browser.loading;

import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * The shader sources of a running scene. The source of a shader part that is new or has a new url
 * or sourceCode arrives later; until then the previous one is used.
 */
final class ShaderUpdater {
  private final RunningSceneLoader files;
  private final AssetStore store;

  /** The field values from which each part's source was read. */
  private final Map<Node, Source> requested = new WeakHashMap<>();

  /**
   * The fields that give a part's source. Compared by identity, since a changed field always gets a
   * new object.
   */
  private record Source(Object url, Object code) {
    static Source of(Node part) {
      return new Source(part.strings("url"), part.string("sourceCode"));
    }

    boolean same(Source other) {
      return url == other.url && code.equals(other.code);
    }
  }

  ShaderUpdater(RunningSceneLoader files, AssetStore store) {
    this.files = files;
    this.store = store;
  }

  Optional<ShaderSource> text(Node part) {
    if (!requested.containsKey(part)) {
      if (store.hasShader(part)) {
        requested.put(part, Source.of(part));
      } else {
        request(part);
      }
    }
    return store.shader(part);
  }

  void changed(Node part) {
    Source known = requested.get(part);
    if (known == null || !known.same(Source.of(part))) {
      request(part);
    }
  }

  private void request(Node part) {
    Source source = Source.of(part);
    requested.put(part, source);
    files.shader(part, text -> arrived(part, source, text));
  }

  private void arrived(Node part, Source source, Optional<ShaderSource> text) {
    if (requested.get(part) == source) {
      store.putShader(part, text);
      part.tellObservers(part.type().indexOf("url"));
    }
  }
}
