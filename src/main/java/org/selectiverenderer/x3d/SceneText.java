package org.selectiverenderer.x3d;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A scene's file as its author's text: what an edit leaves alone keeps every byte, encoding, byte
 * order mark and ends of lines included.
 */
public final class SceneText {
  // Coordinates may be megabytes, and nobody asks for them here.
  private static final List<String> KEPT =
      List.of("DEF", "USE", "containerField", "fromNode", "toNode", "localDEF", "inlineDEF", "url");

  private final EncodedText text;
  private final SceneElement root;

  private SceneText(EncodedText text, SceneElement root) {
    this.text = text;
    this.root = root;
  }

  /**
   * Reads a file's bytes, not compressed.
   *
   * @param name for messages
   * @throws IOException if the text could not be written again as it was, or is not well formed
   */
  public static SceneText of(String name, byte[] bytes) throws IOException {
    EncodedText text = EncodedText.of(bytes);
    if (text.complaint().isPresent()) {
      throw new IOException(
          name + ": " + text.complaint().get() + ", so it cannot be changed safely");
    }
    SceneElement root = elements(name, text);
    if (!text.exact()) {
      throw new IOException(
          name
              + ": its "
              + text.encoding()
              + " cannot be written again as it is, so it is not changed");
    }
    return new SceneText(text, root);
  }

  private static SceneElement elements(String name, EncodedText text) throws IOException {
    TreeBuilder tree = new TreeBuilder(name);
    try {
      text.scan(tree);
    } catch (XmlFault e) {
      throw new IOException(new Location(name, e.line(), e.column()) + ": " + e.getMessage(), e);
    }
    return tree.root();
  }

  /** The text, without a byte order mark. */
  public String characters() {
    return text.characters();
  }

  /** The element X3D. */
  public SceneElement root() {
    return root;
  }

  /** The place of a character. */
  public Location location(String file, int offset) {
    return text.location(file, offset);
  }

  /** Another text in this one's encoding; characters that it does not have become references. */
  public byte[] bytes(String changed) {
    return text.bytes(changed);
  }

  private static final class TreeBuilder implements ElementListener {
    private final String file;
    private @Nullable SceneElement root;
    private @Nullable SceneElement open;

    TreeBuilder(String file) {
      this.file = file;
    }

    @Override
    public void start(Tag tag) {
      List<String[]> attributes = new ArrayList<>();
      for (String name : KEPT) {
        String value = tag.attribute(name);
        if (value != null) {
          attributes.add(new String[] {name, value});
        }
      }
      Location at = new Location(file, tag.line(), tag.column());
      open = new SceneElement(tag.name(), open, at, tag.start(), attributes);
      root = root == null ? open : root;
    }

    @Override
    public void end(int offset) {
      if (open != null) {
        open.endAt(offset);
        open = open.parent().orElse(null);
      }
    }

    /** The scanner has found an element if it has not failed. */
    SceneElement root() {
      if (root == null) {
        throw new IllegalStateException("no element has been found");
      }
      return root;
    }
  }
}
