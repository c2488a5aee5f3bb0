package org.selectiverenderer.validation;

import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.ContentRoot;
import org.selectiverenderer.x3d.ParsedNode;

/**
 * What a {@link SceneCheck} sees: a scene's own file and the files that its Inlines name, directly
 * or through others.
 *
 * @param main the scene's own file
 * @param root decides which files the scene may name
 * @param contents the file in each Inline, of whichever file; none for one that cannot be had
 */
public record SceneView(
    FileOutline main,
    ContentRoot root,
    Map<ParsedNode, FileOutline> contents,
    ValidationSettings settings) {
  /** The file in an Inline; empty if it is not to be loaded or could not be read. */
  public Optional<FileOutline> content(ParsedNode inline) {
    return Optional.ofNullable(contents.get(inline));
  }
}
