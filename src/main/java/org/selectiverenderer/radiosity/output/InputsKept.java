package org.selectiverenderer.radiosity.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.x3d.files.FilesNamed;

/**
 * The files that a scene is made of: none of its lit copy may take their place, and no picture
 * either.
 */
public final class InputsKept {
  /** What follows the name of a lit file in those of its pictures. */
  private static final Pattern PICTURE =
      Pattern.compile("-(.*-)?(light|bright)(-\\d+)?\\.png", Pattern.DOTALL);

  private final Path scene;
  private final Set<Path> read = new LinkedHashSet<>();

  /** What its Inlines' lit copies are called, in small letters and without ending. */
  private final Set<String> copies = new HashSet<>();

  /**
   * @param scene the file of the scene itself
   * @param tree of that scene
   * @param named by that scene: what it inlines, shows and plays
   */
  public InputsKept(Path scene, InstanceTree tree, FilesNamed named) {
    this.scene = scene;
    read.add(scene);
    walk(tree.root());
    read.addAll(named.list());
  }

  private void walk(Instance instance) {
    if (instance instanceof GroupInstance group) {
      if (group.node() instanceof InlineNode inline) {
        inline.content().ifPresent(content -> add(Path.of(content.url())));
      }
      group.children().forEach(this::walk);
    }
  }

  private void add(Path file) {
    read.add(file);
    copies.add(LitFiles.stem(name(file)));
  }

  /**
   * To be asked before the long work.
   *
   * @param output the file of the lit scene
   * @param folder for what it inlines
   * @param preview a picture of the work, or null
   * @throws IOException with one line, if one of these would be written over
   */
  public void stay(Path output, Path folder, @Nullable Path preview) throws IOException {
    for (Path file : read) {
      if (preview != null && same(file, preview)) {
        throw new IOException(
            "%s: would be written over by the preview, and the scene is made of it; name another file"
                    .formatted(shown(file))
                + " (--preview)");
      }
      if (same(file, output)
          || picture(file, output.toAbsolutePath().getParent(), LitFiles.stem(name(output)))
          || copied(file, folder)) {
        throw new IOException(
            "%s: would be written over, and the scene is made of it; name another file (--output) or"
                    .formatted(shown(file))
                + " folder (--inline-dir) for the lit scene");
      }
    }
  }

  /** Whether the lit copy of an Inline, or one of its pictures, may be called so. */
  private boolean copied(Path file, Path folder) throws IOException {
    for (String stem : copies) {
      if (name(file).equals(stem + ".x3d") && same(file.toAbsolutePath().getParent(), folder)
          || picture(file, folder, stem)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a picture of a lit file may be called so: they begin with its name.
   *
   * @param stem of the lit file, in small letters
   */
  private static boolean picture(Path file, @Nullable Path folder, String stem) throws IOException {
    String name = name(file);
    return folder != null
        && name.startsWith(stem + "-")
        && PICTURE.matcher(name.substring(stem.length())).matches()
        && same(file.toAbsolutePath().getParent(), folder);
  }

  /** As the user named it, where he did. */
  private Path shown(Path file) throws IOException {
    return same(file, scene) ? scene : file;
  }

  private static boolean same(@Nullable Path one, Path other) throws IOException {
    return one != null && Files.exists(one) && Files.exists(other) && Files.isSameFile(one, other);
  }

  private static String name(Path file) {
    return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
  }
}
