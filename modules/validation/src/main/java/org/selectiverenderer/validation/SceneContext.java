package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The context of a {@link SceneCheck}: a scene's own file and the files that its Inlines name,
 * directly or through others.
 *
 * @param main the scene's own file
 * @param root decides which files the scene may refer to
 * @param contents the file of each Inline, in whichever file the Inline is; no entry for an Inline
 *     whose file cannot be read
 * @param part whether another scene of the run inlines this one, so that checks of the complete
 *     enrichment run on that scene
 */
public record SceneContext(
    FileOutline main,
    UrlResolver root,
    Map<ParsedNode, FileOutline> contents,
    boolean part,
    ValidationSettings settings) {
  /** Returns the file of an Inline; empty if it is not to be loaded or could not be read. */
  public Optional<FileOutline> content(ParsedNode inline) {
    return Optional.ofNullable(contents.get(inline));
  }

  /** Returns all files, the scene's own first, each once. */
  public List<FileOutline> files() {
    Set<FileOutline> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<FileOutline> files = new ArrayList<>();
    seen.add(main);
    files.add(main);
    for (int i = 0; i < files.size(); i++) {
      for (ParsedNode node : files.get(i).nodes()) {
        content(node).filter(seen::add).ifPresent(files::add);
      }
    }
    return files;
  }
}
