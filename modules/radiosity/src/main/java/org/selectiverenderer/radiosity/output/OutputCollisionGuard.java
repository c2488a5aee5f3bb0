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
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.x3d.url.ReferencedFiles;

/**
 * Guards the files that a scene is read from: neither the lit copy nor one of its images nor the
 * preview may overwrite them.
 */
public final class OutputCollisionGuard {
  /** The part of an image's file name that follows the name of its lit file. */
  private static final Pattern PICTURE =
      Pattern.compile("-(.*-)?(light|bright)(-\\d+)?\\.png", Pattern.DOTALL);

  private final Path scene;
  private final Set<Path> read = new LinkedHashSet<>();

  /** The file names of the lit copies of Inlines, in lower case and without extension. */
  private final Set<String> copies = new HashSet<>();

  /**
   * @param scene the file of the scene itself
   * @param tree the scene's instance tree
   * @param named the files that the scene names: those that it inlines, shows and plays
   */
  public OutputCollisionGuard(Path scene, InstanceTree tree, ReferencedFiles named) {
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
    copies.add(LitFileSet.stem(name(file)));
  }

  /**
   * Checks the output files; to be called before the long computation.
   *
   * @param output the file for the lit scene
   * @param folder the folder for the files that the lit scene inlines
   * @param preview the preview image, or null
   * @throws IOException if an input file would be overwritten; the message is one line
   */
  public void stay(Path output, Path folder, @Nullable Path preview) throws IOException {
    for (Path file : read) {
      if (preview != null && same(file, preview)) {
        throw new IOException(
            "%s: the scene is made of this file, and the preview would overwrite it; name another"
                    .formatted(shown(file))
                + " file with --preview");
      }
      if (same(file, output)
          || picture(file, output.toAbsolutePath().getParent(), LitFileSet.stem(name(output)))
          || copied(file, folder)) {
        throw new IOException(
            "%s: the scene is made of this file, and the lit scene would overwrite it; name another"
                    .formatted(shown(file))
                + " file with --output or another folder with --inline-dir");
      }
    }
  }

  /** Returns whether the lit copy of an Inline, or one of its images, may have this file's name. */
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
   * Returns whether an image of a lit file may have this file's name; such names begin with that of
   * the lit file.
   *
   * @param stem file name of the lit file without extension, in lower case
   */
  private static boolean picture(Path file, @Nullable Path folder, String stem) throws IOException {
    String name = name(file);
    return folder != null
        && name.startsWith(stem + "-")
        && PICTURE.matcher(name.substring(stem.length())).matches()
        && same(file.toAbsolutePath().getParent(), folder);
  }

  /** Returns the path as the user gave it, if the file is the scene itself. */
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
