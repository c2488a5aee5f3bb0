package org.selectiverenderer.runtime.loading;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.ContentRoot;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.ReadLimits;
import org.selectiverenderer.x3d.X3dReader;
import org.selectiverenderer.x3d.geometry.Tessellator;

/**
 * Loads scenes. Owns as many threads as there are processors, named {@code scene-loader-N}, until
 * it is closed. All scenes of one loader share their assets, so that nodes of one may be put into
 * another. Thread-safe.
 */
public final class SceneLoader implements AutoCloseable {
  private final NodeCatalogue catalogue;
  private final NodeFactory factory;
  private final X3dReader reader;
  private final Tessellator tessellator = new Tessellator();
  private final Problems problems;
  private final AssetStore assets;
  private final ExecutorService executor;

  /**
   * @param problems hears what is wrong with the files read
   */
  public SceneLoader(
      NodeCatalogue catalogue, NodeFactory factory, ReadLimits limits, Problems problems) {
    this.catalogue = catalogue;
    this.factory = factory;
    this.problems = problems;
    reader = new X3dReader(catalogue, limits);
    assets = new AssetStore(node -> tessellator.tessellate(node, problems), this::image);
    AtomicInteger count = new AtomicInteger();
    executor =
        Executors.newFixedThreadPool(
            Runtime.getRuntime().availableProcessors(),
            task -> {
              Thread thread = new Thread(task, "scene-loader-" + count.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            });
  }

  /** The meshes and images of all scenes of this loader. */
  public Assets assets() {
    return assets;
  }

  public NodeCatalogue catalogue() {
    return catalogue;
  }

  public NodeFactory factory() {
    return factory;
  }

  /**
   * Reads a scene and everything it inlines.
   *
   * @throws IOException with a one-line message when the file itself cannot be read
   */
  public LoadedScene load(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new IOException(file + " is a folder, not a scene");
    }
    try (InputStream in = Files.newInputStream(file)) {
      Path real = file.toRealPath();
      return build(load(file.toString(), in, real, folderOf(file)), file.toString());
    } catch (NoSuchFileException e) {
      throw new NoSuchFileException(file + ": there is no such file");
    }
  }

  /**
   * Reads a scene from a stream.
   *
   * @param name for messages
   * @param folder against which its urls are resolved
   */
  public LoadedScene load(String name, InputStream in, Path folder) throws IOException {
    return build(load(name, new BufferedInputStream(in), folder, folder), name);
  }

  private static Path folderOf(Path file) {
    Path parent = file.getParent();
    return parent == null ? Path.of("") : parent;
  }

  private FileContent load(String name, InputStream in, Path path, Path folder) throws IOException {
    ContentRoot root = new ContentRoot(folder.toAbsolutePath());
    return new FileLoader(reader, tessellator, executor, root).load(name, in, path, folder);
  }

  private LoadedScene build(FileContent content, String name) {
    Scene scene = new SceneBuilder(catalogue, factory, assets, problems).build(content, List.of());
    return new LoadedScene(scene, assets);
  }

  /** Images of nodes that were not part of a file when it was loaded. */
  private Optional<Texture.Image> image(Node texture) {
    if (!texture.type().name().equals("PixelTexture")) {
      return Optional.empty();
    }
    try {
      return Optional.of(ImageDecoder.pixels(texture.ints("image")));
    } catch (IOException e) {
      problems.error(
          texture.location(),
          "the image of the PixelTexture %s; the texture is left out".formatted(e.getMessage()));
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    executor.shutdownNow();
  }
}
