package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
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

  private final NodeCatalogue catalogue;
  private final ContentAccessPolicy access;
  private final PngTranscoder transcoder;

  /**
   * Creates a writer.
   *
   * @param access further folders and hosts that scenes may refer to
   * @param transcoder converts the images that glTF cannot hold
   */
  public GlbWriter(NodeCatalogue catalogue, ContentAccessPolicy access, PngTranscoder transcoder) {
    this.catalogue = catalogue;
    this.access = access;
    this.transcoder = transcoder;
  }

  /**
   * Returns the bytes of a glTF file of a scene.
   *
   * @param folder the base of the scene's relative urls
   * @param problems receives a warning for each kind of node that glTF cannot hold, and an error
   *     for what cannot be read
   * @return empty if the scene is beyond a limit, which is reported
   */
  public Optional<byte[]> bytes(X3dFile scene, Path folder, Form form, ProblemCollector problems) {
    UrlResolver root = new UrlResolver(folder, access);
    GltfSceneBuilder builder =
        new GltfSceneBuilder(new X3dReader(catalogue), root, transcoder, new GltfLosses(problems));
    try {
      GltfDocument document =
          builder.build(scene, new GltfPlace(scene, "", BaseUrl.folder(folder), 0, 1));
      return Optional.of(form == Form.GLB ? document.glb() : document.gltf());
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a tree of JSON nodes can always be written", e);
    } catch (IOException e) {
      problems.error(SourceLocation.of(scene.source()), e.getMessage() + "; nothing is written");
      return Optional.empty();
    }
  }
}
