package org.selectiverenderer.runtime.loading;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.shader.ShaderText;

/**
 * A parsed file with the meshes and images of its nodes and the files that its Inlines name. A file
 * that is inlined ten times is read once. Several threads fill it; it is read when all have
 * finished.
 *
 * @param key the key of the file; for text without a file, the folder to which it belongs
 * @param base the base of its relative urls
 * @param problems the problems found in this file, collected so that they can be reported in
 *     document order
 * @param types the names of the node types in the file
 * @param programs the programs of the Scripts that have a usable one
 * @param shaders the sources of shader parts
 * @param sounds the recordings of the AudioClips whose files could be read
 * @param pictures the textures made for the images of Background nodes
 * @param inlines the outcome of reading each Inline's file; complete when all threads have finished
 */
record FileContent(
    String key,
    ContentBase base,
    X3dFile file,
    FileProblems problems,
    Set<String> types,
    Map<ParsedNode, Optional<Mesh>> meshes,
    Map<ParsedNode, Optional<Texture.Image>> images,
    Map<ParsedNode, ScriptProgram> programs,
    Map<ParsedNode, Optional<ShaderText>> shaders,
    Map<ParsedNode, Recording> sounds,
    Map<ParsedNode, Map<Backdrop.Side, ParsedNode>> pictures,
    Map<ParsedNode, CompletableFuture<Outcome>> inlines) {

  private static final long LEAST_OF_ONE = 40;

  /** Number of pixels whose upload to the GPU takes as long as preparing one triangle. */
  private static final long PIXELS = 50;

  /** The outcome of reading a file. */
  sealed interface Outcome {
    /** The file was read, possibly with problems. */
    record Read(FileContent content) implements Outcome {}

    /**
     * The file could not be read.
     *
     * @param sentence the reason, with the file's name
     */
    record Failed(String sentence) implements Outcome {}
  }

  FileContent(String key, ContentBase base, X3dFile file) {
    this(
        key,
        base,
        file,
        new FileProblems(),
        ConcurrentHashMap.newKeySet(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>());
  }

  /**
   * Returns the cost of showing the file with its Inlines, in triangles: a shape counts as at least
   * {@link #LEAST_OF_ONE} triangles, and {@link #PIXELS} pixels of an image count as one. Each
   * inlined file counts once, however often it is inlined, since files may inline each other and
   * meshes are shared.
   */
  long work() {
    Set<FileContent> files = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<FileContent> open = new ArrayDeque<>(List.of(this));
    long work = 0;
    while (!open.isEmpty()) {
      FileContent file = open.pop();
      if (!files.add(file)) {
        continue;
      }
      for (Optional<Mesh> mesh : file.meshes.values()) {
        work += Math.max(LEAST_OF_ONE, mesh.map(Mesh::polygons).orElse(0));
      }
      for (Optional<Texture.Image> image : file.images.values()) {
        work += image.map(of -> (long) of.rgba().length).orElse(0L) / (4 * PIXELS);
      }
      for (CompletableFuture<Outcome> inlined : file.inlines.values()) {
        if (inlined.join() instanceof Outcome.Read read) {
          open.push(read.content());
        }
      }
    }
    return work;
  }

  void error(Location location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.ERROR, location, message)));
  }

  void warning(Location location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.WARNING, location, message)));
  }

  void info(Location location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.INFO, location, message)));
  }
}
