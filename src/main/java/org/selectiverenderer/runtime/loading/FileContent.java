package org.selectiverenderer.runtime.loading;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.Problem;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dFile;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * A file as read, with the meshes and images of its nodes and the files that its Inlines name. A
 * file that is inlined ten times is read once. Filled by several threads, read when all are done.
 *
 * @param path the real path; for text without a file, the folder it counts as being in
 * @param problems found in this file, kept apart so that they can be reported in document order
 */
record FileContent(
    Path path,
    X3dFile file,
    Problems problems,
    Map<NodeView, Optional<Mesh>> meshes,
    Map<NodeView, Optional<Texture.Image>> images,
    Map<ParsedNode, FileReference> inlines) {

  /** The file that an Inline turned out to name. */
  interface FileReference {
    /** Its content; empty when it could not be read. To be called when all threads are done. */
    Optional<FileContent> content();
  }

  FileContent(Path path, X3dFile file, Problems problems) {
    this(
        path,
        file,
        problems,
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>(),
        new ConcurrentHashMap<>());
  }

  List<Problem> problemList() {
    return problems.list();
  }
}
