package org.selectiverenderer.browser.loading;

import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * The assets of a running scene. The image of a new texture or of one with a new url arrives later;
 * until then the previous one is shown. A texture with {@code load FALSE} has none.
 */
final class RunningSceneAssets implements AssetProvider {
  private static final String[] NONE = {};

  private final RunningSceneLoader files;
  private final AssetStore store;
  private final ShaderUpdater shaders;

  /** The url whose image each texture has or is waiting for. */
  private final Map<Node, String[]> requested = new WeakHashMap<>();

  RunningSceneAssets(RunningSceneLoader files, AssetStore store) {
    this.files = files;
    this.store = store;
    shaders = new ShaderUpdater(files, store);
  }

  @Override
  public Optional<Mesh> mesh(Node geometry) {
    return store.mesh(geometry);
  }

  @Override
  public Optional<Texture.Image> image(Node texture) {
    if (fromFile(texture) && !requested.containsKey(texture)) {
      if (store.hasImage(texture)) {
        requested.put(texture, url(texture));
      } else {
        request(texture);
      }
    }
    return store.image(texture);
  }

  @Override
  public Optional<ShaderSource> shader(Node part) {
    return ShaderLoader.named(part.type()) ? shaders.text(part) : Optional.empty();
  }

  @Override
  public void told(Problem problem) {
    files.told(problem);
  }

  @Override
  public Optional<Node> picture(Node background, Background.Side side) {
    return files.picture(background, side);
  }

  @Override
  public boolean multiplies(Node texture) {
    return store.multiplies(texture);
  }

  @Override
  public void asOf(Node node, int changes) {
    if (!fromFile(node) && !ShaderLoader.named(node.type())) {
      store.asOf(node, changes);
    } else if (requested.containsKey(node) || !(node instanceof MovieTextureNode)) {
      changed(node); // Keeps a movie from the file, which runs unseen.
    }
  }

  @Override
  public void changed(Node node) {
    if (ShaderLoader.named(node.type())) {
      shaders.changed(node);
    } else if (!fromFile(node)) {
      store.changed(node);
    } else if (requested.get(node) != url(node)) {
      request(node);
    }
  }

  private static boolean fromFile(Node node) {
    return ImageLoader.named(node.type());
  }

  /** Returns the urls that a texture is to show: none if its {@code load} is FALSE. */
  private static String[] url(Node texture) {
    return ImageLoader.wanted(texture) ? texture.strings("url") : NONE;
  }

  private void request(Node texture) {
    String[] url = url(texture);
    requested.put(texture, url);
    if (url.length > 0) {
      files.image(texture, image -> arrived(texture, url, image));
    } else {
      store.putImage(texture, Optional.empty());
    }
  }

  private void arrived(Node texture, String[] url, Optional<Texture.Image> image) {
    if (requested.get(texture) == url) {
      store.putImage(texture, image);
      texture.tellObservers(texture.type().indexOf("url"));
    }
  }
}
