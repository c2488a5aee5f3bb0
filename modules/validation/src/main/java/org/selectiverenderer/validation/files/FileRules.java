package org.selectiverenderer.validation.files;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** Declares the rules SR300 to SR399, about the files that a scene names. */
public final class FileRules {
  private static final String GOOD = "<Inline url='\"inlineNodes/desk.x3d\"'/>";

  static final Rule MISSING =
      Rule.error("SR301", "url '{url}' is missing")
          .because(
              "The file that the node should show does not exist. Paths are relative "
                  + "to the scene's folder.")
          .bad("<Inline url='\"inlineNodes/dsek.x3d\"'/>")
          .good(GOOD)
          .see("X3D 4.0, 9.2.1");

  static final Rule CASE =
      Rule.error("SR302", "url '{url}' differs from the file {file} in upper and lower case")
          .because(
              """
              Windows and macOS treat such names as equal, Linux and web servers do not. The \
              scene works on one machine and is empty on another.""")
          .bad("<Inline url='\"inlineNodes/Desk.x3d\"'/>")
          .good(GOOD)
          .see("RFC 3986, 6.2.2.1");

  static final Rule OUTSIDE =
      Rule.warning(
              "SR303", "url '{url}' points outside the folders this scene may name (see --allow)")
          .because(
              """
              A scene may name files in its own folder, below it, in a folder inlineNodes beside \
              it, and in its project: the nearest folder above with a .git or an x3d-project. \
              Other files would be missing after the project is copied. --allow DIR, or "allow" \
              in the settings, opens further folders.""")
          .bad("<Inline url='\"../../../somewhere/desk.x3d\"'/>")
          .good(GOOD)
          .see("docs/validate.md");

  static final Rule NETWORK =
      Rule.warning("SR304", "url '{url}' {reason}")
          .because(
              """
              Nothing is fetched from the network unless --allow-net HOST, or "allowNet" in the \
              settings, names the host. Keep a copy beside the scene and name it first.""")
          .bad("<Inline url='\"https://example.org/desk.x3d\"'/>")
          .good("<Inline url='\"inlineNodes/desk.x3d\" \"https://example.org/desk.x3d\"'/>")
          .see("X3D 4.0, 9.2.1");

  static final Rule NO_NAME =
      Rule.error("SR305", "url '{url}' {reason}")
          .because("Such a url does not name a file.")
          .bad("<Inline url='\"inlineNodes/\"'/>")
          .good(GOOD)
          .see("RFC 3986");

  static final Rule EMPTY =
      Rule.info("SR306", "{node} has no url")
          .because("The node shows nothing until an application gives it a url.")
          .bad("<Inline/>")
          .good(GOOD)
          .see("X3D 4.0, 9.4.2");

  static final Rule CIRCLE =
      Rule.error("SR307", "{file} would be inlined within itself here")
          .because("This would never end; the inner Inline is left out.")
          .bad("desk.x3d: <Inline url='\"desk.x3d\"'/>")
          .good("desk.x3d: <Inline url='\"leg.x3d\"'/>")
          .see("X3D 4.0, 9.4.2");

  static final Rule SECOND_MISSING =
      Rule.warning("SR308", "url '{url}' {reason}; another url of the node is used")
          .because("A url that never works is a mistake or a leftover; remove or correct it.")
          .bad("<Inline url='\"inlineNodes/dsek.x3d\" \"inlineNodes/desk.x3d\"'/>")
          .good(GOOD)
          .see("X3D 4.0, 9.2.1");

  static final Rule UNREADABLE =
      Rule.error("SR309", "url '{url}' cannot be read")
          .because("The file exists, but you have no permission to read it.")
          .bad("<Inline url='\"locked.x3d\"'/>")
          .good(GOOD)
          .see("docs/validate.md");

  static final Rule ABSOLUTE =
      Rule.warning("SR310", "url '{url}' is an absolute path, which no other machine has")
          .because("Name files relative to the scene, so that its folder can be moved and copied.")
          .bad("<Inline url='\"file:///home/me/desk.x3d\"'/>")
          .good(GOOD)
          .see("X3D 4.0, 9.2.1; RFC 3986, 4.2");

  static final Rule BACKSLASH =
      Rule.warning("SR311", "url '{url}' has backslashes, which separate folders on Windows only")
          .because("Use forward slashes in a url, on every system.")
          .bad("<Inline url='\"inlineNodes\\desk.x3d\"'/>")
          .good(GOOD)
          .see("RFC 3986, 3.3");

  static final Rule SIZE =
      Rule.warning("SR312", "the scene and its {count} files have {size} MB, more than {most} MB")
          .because(
              """
              A scene of that size is slow to load and may not fit into memory. The limit is \
              100 MB unless the settings state another one ("megabytes").""")
          .bad("(a scene that inlines 120 MB)")
          .good("(a scene that inlines 30 MB)")
          .see("docs/validate.md");

  static final Rule FOREIGN_MOVIE =
      Rule.warning(
              "SR313", "no url of the MovieTexture names a movie in a format that X3D requires")
          .because(
              """
              The standard asks browsers for MPEG-1 only; this program shows that and animated \
              GIFs. MP4, WebM and the like are shown by some browsers. `ffmpeg -i FILE -r 25 \
              FILE.mpg` makes such a film; name it beside the other.""")
          .bad("<MovieTexture url='\"clip.mp4\"'/>")
          .good("<MovieTexture url='\"clip.mp4\" \"clip.mpg\"'/>")
          .see("X3D 4.0, 18.4.2");

  private FileRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Files",
        List.of(
            MISSING,
            CASE,
            OUTSIDE,
            NETWORK,
            NO_NAME,
            EMPTY,
            CIRCLE,
            SECOND_MISSING,
            UNREADABLE,
            ABSOLUTE,
            BACKSLASH,
            SIZE,
            FOREIGN_MOVIE),
        List.of(),
        List.of(new UrlCheck(), new InlineCycleCheck(), new FileSizeCheck()));
  }
}
