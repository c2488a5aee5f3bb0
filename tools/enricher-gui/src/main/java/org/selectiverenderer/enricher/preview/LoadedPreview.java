package org.selectiverenderer.enricher.preview;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * A loaded world that is ready to be shown. Its owner closes it.
 *
 * @param folder against which its urls are resolved
 * @param revision the document's revision; 0 for a file
 */
record LoadedPreview(World world, SceneLoader loader, Path folder, long revision)
    implements AutoCloseable {
  /**
   * Loads a document's snapshot and the files that it names.
   *
   * @param folder against which urls are resolved
   * @param access folders and hosts that the scene may read from
   * @throws IOException with a one-line message when it cannot be read at all
   */
  static LoadedPreview of(DocumentSnapshot snapshot, Path folder, ContentAccessPolicy access)
      throws IOException {
    return of(snapshot.name(), snapshot.bytes(), folder, access, snapshot.revision());
  }

  /**
   * Loads a scene from bytes and the files that it names.
   *
   * @throws IOException with a one-line message when it cannot be read at all
   */
  static LoadedPreview of(
      String name, byte[] bytes, Path folder, ContentAccessPolicy access, long revision)
      throws IOException {
    ProblemCollector problems = new ProblemCollector(); // The document's own checks report them.
    SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), access, problems);
    try {
      LoadedScene loaded = loader.load(name, new ByteArrayInputStream(bytes), folder);
      World world = new World(loaded, problems);
      world.instances().update();
      return new LoadedPreview(world, loader, folder, revision);
    } catch (IOException | RuntimeException | Error e) {
      loader.close();
      throw e;
    }
  }

  @Override
  public void close() {
    loader.close();
  }
}
