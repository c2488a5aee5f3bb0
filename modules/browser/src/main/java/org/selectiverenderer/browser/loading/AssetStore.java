package org.selectiverenderer.browser.loading;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.function.Function;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.movie.MoviePlayback;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeTemplate;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * A store of meshes, images and shader sources by node: those made while loading, and those made
 * later for new or changed nodes. The mesh of a node that is like its {@link NodeTemplate} is
 * there. The store holds nodes weakly. Thread-safe.
 */
final class AssetStore implements AssetProvider {
  // Nodes are compared by identity; no value refers back to its node, so that the weak keys can be
  // cleared.
  private final Map<Node, Optional<Mesh>> meshes = new WeakHashMap<>();
  private final Map<Node, Optional<Texture.Image>> images = new WeakHashMap<>();
  private final Map<Node, Optional<ShaderSource>> shaders = new WeakHashMap<>();
  private final Map<Node, Integer> changes = new WeakHashMap<>();
  private final Function<Node, Optional<Mesh>> tessellate;
  private final Function<Node, Optional<Texture.Image>> decode;

  private final Set<Node> multiplying = Collections.newSetFromMap(new WeakHashMap<>());

  private final ProblemCollector problems;

  /**
   * @param problems receives the errors of shader programs that do not compile
   */
  AssetStore(
      Function<Node, Optional<Mesh>> tessellate,
      Function<Node, Optional<Texture.Image>> decode,
      ProblemCollector problems) {
    this.tessellate = tessellate;
    this.decode = decode;
    this.problems = problems;
  }

  synchronized void putShader(Node part, Optional<ShaderSource> text) {
    shaders.put(part, text);
  }

  /** Returns whether the source of a shader part is known, or known to be missing. */
  synchronized boolean hasShader(Node part) {
    return shaders.containsKey(part);
  }

  @Override
  public synchronized Optional<ShaderSource> shader(Node part) {
    return shaders.getOrDefault(part, Optional.empty());
  }

  @Override
  public void told(Problem problem) {
    problems.add(problem);
  }

  /** Notes that a texture's colour multiplies the material's, as in X3D 4.0. */
  synchronized void multiply(Node texture) {
    multiplying.add(texture);
  }

  @Override
  public synchronized boolean multiplies(Node texture) {
    return multiplying.contains(texture);
  }

  /** Stores an image; each MovieTexture gets a playback of its own. */
  synchronized void putImage(Node texture, Optional<Texture.Image> image) {
    Optional<Texture.Image> own = image;
    if (texture instanceof MovieTextureNode movie) {
      MoviePlayback film = image.map(Texture.Image::film).map(MoviePlayback::anew).orElse(null);
      own = image.map(first -> first.with(film));
      movie.film(film);
    }
    images.put(texture, own);
  }

  /** Returns whether the image of a texture is known, or known to be missing. */
  synchronized boolean hasImage(Node texture) {
    return images.containsKey(texture);
  }

  @Override
  public synchronized Optional<Mesh> mesh(Node geometry) {
    NodeTemplate template = geometry.template();
    Optional<Mesh> shared = template == null ? null : template.mesh();
    return shared != null ? shared : meshes.computeIfAbsent(geometry, tessellate);
  }

  @Override
  public synchronized Optional<Texture.Image> image(Node texture) {
    return images.computeIfAbsent(texture, decode);
  }

  @Override
  public synchronized void asOf(Node node, int now) {
    Integer before = changes.put(node, now);
    if (before == null || before != now) {
      changed(node);
    }
  }

  @Override
  public synchronized void changed(Node node) {
    node.dropTemplate();
    meshes.remove(node);
    images.remove(node);
  }
}
