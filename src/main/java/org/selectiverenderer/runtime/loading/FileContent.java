package org.selectiverenderer.runtime.loading;

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
