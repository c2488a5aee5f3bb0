package org.selectiverenderer.validation.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ScriptProgramSelection;
import org.selectiverenderer.x3d.url.UrlResolver.Cause;
import org.selectiverenderer.x3d.url.UrlResolver.Target;

/** Checks the urls of Inlines, textures, sounds, scripts and shaders. */
final class UrlCheck implements SceneCheck {
  private static final Pattern ABSOLUTE = Pattern.compile("(?i)file:.*|/(?!/).*|[a-z]:[/\\\\].*");

  /** Schemes of urls that contain the program itself. */
  private static final Pattern CONTENT =
      Pattern.compile("(?is)\\s*(javascript|ecmascript|vrmlscript):.*");

  /** Movie formats that some browsers play, but which the standard does not require. */
  private static final Pattern FOREIGN_MOVIE =
      Pattern.compile(
          "(?is)[^?#]*\\.(mp4|m4v|webm|ogv|mov|avi|mkv|wmv)([?#].*)?"
              + "|\\s*data:video/(mp4|webm|ogg|quicktime)\\b.*");

  private static final Set<String> SHOWN_WITHOUT = Set.of("Anchor", "Script");
  private static final int SHOWN = 80;

  @Override
  public void check(SceneContext scene, FindingCollector findings) {
    for (FileOutline file : scene.files()) {
      for (ParsedNode node : file.nodes()) {
        if (node.type().is("X3DUrlObject") && node.type().field("url").isPresent()) {
          new NodeUrls(scene, file, node, findings).check();
        }
      }
    }
  }

  /** A url of a node and the target that it refers to. */
  private record Url(String text, Target target) {}

  private record NodeUrls(
      SceneContext scene, FileOutline file, ParsedNode node, FindingCollector findings) {
    void check() {
      List<Url> urls = new ArrayList<>();
      for (String text : node.strings("url")) {
        if (CONTENT.matcher(text).matches()) {
          return;
        }
        if (node.type().is("X3DScriptNode")
            && ScriptProgramSelection.otherLanguage(text).isPresent()) {
          continue; // SR604 reports it.
        }
        urls.add(new Url(text, scene.root().resolve(text, node.base(file.file().base()))));
      }
      // An Anchor may link to a viewpoint of the scene or to the web.
      if (node.type().name().equals("Anchor")) {
        urls.removeIf(url -> url.text.startsWith("#") || refused(url, Cause.NETWORK));
      }
      if (urls.isEmpty()) {
        if (!SHOWN_WITHOUT.contains(node.type().name()) && !hasContent()) {
          findings.add(FileRules.EMPTY, node, node.type().name());
        }
        return;
      }
      movie(urls);
      urls.forEach(this::spelling);
      urls.removeIf(url -> ABSOLUTE.matcher(url.text.strip()).matches());
      if (!urls.isEmpty()) {
        targets(urls);
      }
    }

    private boolean hasContent() {
      return node.type().field("sourceCode").isPresent() && !node.string("sourceCode").isBlank()
          || node.type().field("children").isPresent() && !node.nodes("children").isEmpty();
    }

    /**
     * Reports a MovieTexture with only non-standard formats; missing files have findings of their
     * own.
     */
    private void movie(List<Url> urls) {
      if (node.type().name().equals("MovieTexture")
          && urls.stream().allMatch(url -> FOREIGN_MOVIE.matcher(url.text).matches())
          && urls.stream().anyMatch(url -> url.target instanceof Target.Found)) {
        add(FileRules.FOREIGN_MOVIE);
      }
    }

    private void spelling(Url url) {
      if (ABSOLUTE.matcher(url.text.strip()).matches()) {
        report(FileRules.ABSOLUTE, url);
      }
      if (url.text.contains("\\")) {
        report(FileRules.BACKSLASH, url);
      }
    }

    private void targets(List<Url> urls) {
      boolean found = urls.stream().anyMatch(url -> url.target instanceof Target.Found);
      boolean first = true;
      for (Url url : urls) {
        if (url.target instanceof Target.Found target) {
          target.content().file().ifPresent(path -> file(url, path));
        } else if (url.target instanceof Target.Refused refused) {
          if (!found && first) {
            refused(url, refused);
          } else if (found && refused.cause() != Cause.NETWORK) {
            report(FileRules.SECOND_MISSING, url, refused.reason());
          }
        }
        first = false;
      }
    }

    private void file(Url url, Path real) {
      String actual = caseOf(url.text, real);
      if (actual != null) {
        report(FileRules.CASE, url, actual);
      } else if (!Files.isReadable(real)) {
        report(FileRules.UNREADABLE, url);
      }
    }

    private void refused(Url url, Target.Refused refused) {
      switch (refused.cause()) {
        case MISSING -> report(FileRules.MISSING, url);
        case CASE -> report(FileRules.CASE, url, similar(refused.reason()));
        case OUTSIDE -> report(FileRules.OUTSIDE, url);
        case NETWORK, UNREACHABLE -> report(FileRules.NETWORK, url, refused.reason());
        case NO_FILE_NAME -> report(FileRules.NO_NAME, url, refused.reason());
      }
    }

    private static boolean refused(Url url, Cause cause) {
      return url.target instanceof Target.Refused refused && refused.cause() == cause;
    }

    private void report(Rule rule, Url url, Object... more) {
      String shown = url.text.length() <= SHOWN ? url.text : url.text.substring(0, SHOWN) + "...";
      Object[] words = new Object[more.length + 1];
      words[0] = shown;
      System.arraycopy(more, 0, words, 1, more.length);
      add(rule, words);
    }

    private void add(Rule rule, Object... words) {
      String name = node.name() == null ? "" : " " + node.name();
      findings.add(rule, file.place(node, "url"), node.type().name() + name, words);
    }
  }

  /** Returns the file name in the reason "is missing (there is Desk.x3d, which differs in ...)". */
  private static String similar(String reason) {
    int start = reason.indexOf("there is ") + "there is ".length();
    return reason.substring(start, reason.lastIndexOf(", which differs"));
  }

  /**
   * Returns the name of a file as it is on a case-insensitive file system if the url spells it with
   * other case; null if they agree.
   */
  private static @Nullable String caseOf(String url, Path real) {
    String name = url.strip().replaceFirst("#.*", "").replace('\\', '/');
    name = name.substring(name.lastIndexOf('/') + 1);
    String actual = String.valueOf(real.getFileName());
    return actual.equalsIgnoreCase(name) && !actual.equals(name) ? actual : null;
  }
}
