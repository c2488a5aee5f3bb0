package org.selectiverenderer.runtime.loading;

import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.shader.ShaderText;

/**
 * The texts of shaders in a running scene. That of a part that is new, or has another text or url,
 * arrives later; until then the one before counts.
 */
final class LiveShaders {
  private final LiveFiles files;
  private final AssetStore store;

  /** What each part's text was made of. */
  private final Map<Node, Source> requested = new WeakHashMap<>();

  /** Compared by identity: fields get other values, not the same changed. */
  private record Source(Object url, Object code) {
    static Source of(Node part) {
      return new Source(part.strings("url"), part.string("sourceCode"));
    }

    boolean same(Source other) {
      return url == other.url && code.equals(other.code);
    }
  }

  LiveShaders(LiveFiles files, AssetStore store) {
    this.files = files;
    this.store = store;
  }

  Optional<ShaderText> text(Node part) {
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

  private void arrived(Node part, Source source, Optional<ShaderText> text) {
    if (requested.get(part) == source) {
      store.putShader(part, text);
      part.tellObservers(part.type().indexOf("url"));
    }
  }
}
