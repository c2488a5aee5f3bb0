package org.selectiverenderer.radiosity.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.group.InlineNode;

/** The files that a scene is made of: none of its lit copy may take their place. */
public final class InputsKept {
  private final Set<Path> read = new LinkedHashSet<>();

  /** What its Inlines' lit copies are called, in small letters. */
  private final Set<String> copies = new HashSet<>();

  /**
   * @param scene the file of the scene itself
   * @param tree of that scene
   */
  public InputsKept(Path scene, InstanceTree tree) {
    read.add(scene);
    walk(tree.root());
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
    copies.add(lower(LitFiles.stem(String.valueOf(file.getFileName())) + ".x3d"));
  }

  /**
   * To be asked before the long work.
   *
   * @param output the file of the lit scene
   * @param folder for what it inlines
   * @throws IOException with one line, if one of these would be written over
   */
  public void stay(Path output, Path folder) throws IOException {
    for (Path file : read) {
      boolean copied = copies.contains(lower(String.valueOf(file.getFileName())));
      if (same(file, output) || (copied && same(file.toAbsolutePath().getParent(), folder))) {
        throw new IOException(
            "%s: would be written over, and the scene is made of it; name another file (--output) or"
                    .formatted(file)
                + " folder (--inline-dir) for the lit scene");
      }
    }
  }

  private static boolean same(@Nullable Path one, Path other) throws IOException {
    return one != null && Files.exists(one) && Files.exists(other) && Files.isSameFile(one, other);
  }

  private static String lower(String name) {
    return name.toLowerCase(Locale.ROOT);
  }
}
