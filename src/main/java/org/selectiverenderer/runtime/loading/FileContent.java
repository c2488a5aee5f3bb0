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
 * A file as read, with the meshes and images of its nodes and the files that its Inlines name. A
 * file that is inlined ten times is read once. Filled by several threads, read when all are done.
 *
 * @param key of what was read; for text without a file, the folder it counts as being in
 * @param base where its relative urls start
 * @param problems found in this file, kept apart so that they can be reported in document order
 * @param types names of the node types in the file
 * @param programs those of Scripts, where they have one that can be used
 * @param shaders the texts of shaders' parts
 * @param sounds those of AudioClips, where their files could be read
 * @param pictures the textures that stand for those of Background nodes
 * @param inlines what became of the file that an Inline names; complete when all threads are done
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

  /** Pixels of an image that are sent to the graphics card while a triangle is made ready. */
  private static final long PIXELS = 50;

  /** What became of reading a file. */
  sealed interface Outcome {
    /** It could be read, however much is wrong with it. */
    record Read(FileContent content) implements Outcome {}

    /**
     * It could not.
     *
     * @param sentence what is wrong, with the file's name
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
   * What it takes to show all of it, in triangles: a shape for at least {@link #LEAST_OF_ONE}, and
   * {@link #PIXELS} of an image for one. Files within it count once, however often and wherever
   * they are inlined: they may inline each other, and meshes are shared.
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
