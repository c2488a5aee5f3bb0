package org.selectiverenderer.browser.loading;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.shader.ShaderSource;
import org.selectiverenderer.x3d.url.BaseUrl;

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
 * @param sounds the recordings of the AudioClips whose files could be read, and the soundtracks of
 *     MovieTextures that are heard
 * @param pictures the textures made for the images of Background nodes
 * @param inlines the outcome of reading each Inline's file; complete when all threads have finished
 */
record LoadedFile(
    String key,
    BaseUrl base,
    X3dFile file,
    OrderedProblems problems,
    Set<String> types,
    Map<ParsedNode, Optional<Mesh>> meshes,
    Map<ParsedNode, Optional<Texture.Image>> images,
    Map<ParsedNode, ScriptProgram> programs,
    Map<ParsedNode, Optional<ShaderSource>> shaders,
    Map<ParsedNode, AudioBuffer> sounds,
    Map<ParsedNode, Map<Background.Side, ParsedNode>> pictures,
    Map<ParsedNode, CompletableFuture<Outcome>> inlines) {

  private static final long LEAST_OF_ONE = 40;

  /** Number of pixels whose upload to the GPU takes as long as preparing one triangle. */
  private static final long PIXELS = 50;

  /** The outcome of reading a file. */
  sealed interface Outcome {
    /** The file was read, possibly with problems. */
    record Read(LoadedFile content) implements Outcome {}

    /**
     * The file could not be read.
     *
     * @param sentence the reason, with the file's name
     */
    record Failed(String sentence) implements Outcome {}
  }

  LoadedFile(String key, BaseUrl base, X3dFile file) {
    this(
        key,
        base,
        file,
        new OrderedProblems(),
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
    long work = 0;
    for (LoadedFile file : withInlines()) {
      for (Optional<Mesh> mesh : file.meshes.values()) {
        work += Math.max(LEAST_OF_ONE, mesh.map(Mesh::polygons).orElse(0));
      }
      for (Optional<Texture.Image> image : file.images.values()) {
        work += image.map(of -> (long) of.rgba().length).orElse(0L) / (4 * PIXELS);
      }
    }
    return work;
  }

  /**
   * Builds the hierarchies of the large meshes of the file with its Inlines, for which a frame
   * would wait when a ray or the viewer first comes near.
   */
  Map<Mesh, MeshBvh> hierarchies() {
    Map<Mesh, MeshBvh> built = new HashMap<>();
    for (LoadedFile file : withInlines()) {
      for (Optional<Mesh> mesh : file.meshes.values()) {
        mesh.filter(of -> of.polygons() > FrameBudgetQueue.MOST)
            .ifPresent(of -> built.computeIfAbsent(of, MeshBvh::new));
      }
    }
    return built;
  }

  /** Returns this file and those that it inlines, directly or not, each once. */
  private Set<LoadedFile> withInlines() {
    Set<LoadedFile> files = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<LoadedFile> open = new ArrayDeque<>(List.of(this));
    while (!open.isEmpty()) {
      LoadedFile file = open.pop();
      if (!files.add(file)) {
        continue;
      }
      for (CompletableFuture<Outcome> inlined : file.inlines.values()) {
        if (inlined.join() instanceof Outcome.Read read) {
          open.push(read.content());
        }
      }
    }
    return files;
  }

  void error(SourceLocation location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.ERROR, location, message)));
  }

  void warning(SourceLocation location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.WARNING, location, message)));
  }

  void info(SourceLocation location, String message) {
    problems.addAll(List.of(new Problem(Problem.Severity.INFO, location, message)));
  }

  /**
   * The problems of one file in document order, regardless of the thread that finds them. It keeps
   * only as many as will be listed, the first ones in that order. Thread-safe.
   */
  static final class OrderedProblems {
    /** Order by location; problems of the file as a whole come last. */
    private static final Comparator<Problem> DOCUMENT_ORDER =
        Comparator.comparingInt(OrderedProblems::line)
            .thenComparingInt(problem -> problem.location().column())
            .thenComparing(Problem::severity)
            .thenComparing(Problem::message);

    private final TreeSet<Problem> first = new TreeSet<>(DOCUMENT_ORDER);

    private static int line(Problem problem) {
      int line = problem.location().line();
      return line == 0 ? Integer.MAX_VALUE : line;
    }

    synchronized void addAll(Collection<Problem> problems) {
      for (Problem problem : problems) {
        first.add(problem);
        if (first.size() > ProblemCollector.LIMIT + 1) {
          first.pollLast();
        }
      }
    }

    synchronized List<Problem> list() {
      return List.copyOf(first);
    }
  }
}
