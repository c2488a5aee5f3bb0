package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Writes an X3D scene as glTF 2.0, in metres, with y up: geometry as triangles, lines and points,
 * materials, textures, viewpoints, lights, moving Transforms, and metadata. Inlines and prototype
 * instances are expanded. The same scene gives the same bytes on every machine. Thread-safe.
 */
public final class GlbWriter {
  /** The two forms of a file. */
  public enum Form {
    /** One binary file. */
    GLB,
    /** JSON, with vertices and images as {@code data:} urls. */
    GLTF;

    /** Returns the form that a file name extension names, {@code .glb} or {@code .gltf}. */
    public static Optional<Form> of(String name) {
      String lower = name.toLowerCase(Locale.ROOT);
      return lower.endsWith(".glb")
          ? Optional.of(GLB)
          : lower.endsWith(".gltf") ? Optional.of(GLTF) : Optional.empty();
    }
  }

  private final X3dReader reader;
  private final ContentAccessPolicy access;

  /**
   * Creates a writer.
   *
   * @param access further folders and hosts that scenes may refer to
   */
  public GlbWriter(NodeCatalogue catalogue, ContentAccessPolicy access) {
    this.reader = new X3dReader(catalogue);
    this.access = access;
  }

  /**
   * Returns the bytes of a glTF file of a scene.
   *
   * @param problems receives a warning for each kind of node that glTF cannot hold, and an error
   *     for what cannot be read
   * @return empty if the scene is beyond a limit, which is reported
   * @throws IOException if the scene's own file cannot be read, with one line that names it
   */
  public Optional<byte[]> bytes(Path scene, Form form, ProblemCollector problems)
      throws IOException {
    Path parent = scene.toAbsolutePath().getParent();
    Path folder = parent == null ? scene.toAbsolutePath() : parent;
    UrlResolver root = new UrlResolver(folder, access);
    BaseUrl base = BaseUrl.folder(folder);
    X3dFile file =
        reader.with(new PrototypeLibraryLoader(reader, root), base).read(scene, problems);
    GltfSceneBuilder builder = new GltfSceneBuilder(reader, root, new GltfLosses(problems));
    try {
      GltfDocument document = builder.build(file, new GltfPlace(file, base, 0));
      return Optional.of(form == Form.GLB ? document.glb() : document.gltf());
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a tree of JSON nodes can always be written", e);
    } catch (IOException e) {
      problems.error(SourceLocation.of(scene.toString()), e.getMessage() + "; nothing is written");
      return Optional.empty();
    }
  }
}
