package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/**
 * Converts the inline code of scripts and shaders between encodings. XML and JSON have it in the
 * node; VRML has it as the last url, with its language as the scheme (ISO/IEC 14772-1, 4.12.8; X3D
 * 4.0, 29.2.6).
 */
final class InlineCodeConverter {
  private static final String SCRIPT = "ecmascript:";
  private static final String SHADER = "data:text/plain,";
  private static final List<String> SCRIPTS = List.of(SCRIPT, "javascript:", "vrmlscript:");

  private InlineCodeConverter() {}

  /**
   * Returns the code of a node.
   *
   * @param values the values of the node, from which a url that is code is removed
   * @param text the text in the node
   */
  static String of(@Nullable NodeType type, List<Value> values, String text) {
    if (!text.isBlank()) {
      return text.strip();
    }
    for (int i = 0; i < values.size(); i++) {
      Value value = values.get(i);
      if (value.name().equals("sourceCode")) {
        values.remove(i);
        return value.text().strip();
      }
      if (value.name().equals("url")) {
        List<String> urls = new ArrayList<>(strings(value.text()));
        Optional<String> code =
            urls.isEmpty() ? Optional.empty() : code(type, urls.get(urls.size() - 1));
        if (code.isPresent()) {
          urls.remove(urls.size() - 1);
          values.remove(i);
          if (!urls.isEmpty()) {
            values.add(i, new Value("url", FieldType.MFString, FieldValueFormatter.strings(urls)));
          }
          return code.get();
        }
      }
    }
    return "";
  }

  private static Optional<String> code(@Nullable NodeType type, String url) {
    String start = url.stripLeading();
    if (type != null && !type.is("X3DScriptNode")) {
      // other percent-encoding is that of an author, and such a url stays one
      boolean ours = start.startsWith(SHADER) && !start.replace("%25", "").contains("%");
      return ours
          ? Optional.of(start.substring(SHADER.length()).replace("%25", "%").strip())
          : Optional.empty();
    }
    return language(start)
        .map(language -> SCRIPT + start.substring(language.length()).stripTrailing());
  }

  private static Optional<String> language(String code) {
    String lower = code.substring(0, Math.min(20, code.length())).toLowerCase(Locale.ROOT);
    return SCRIPTS.stream().filter(lower::startsWith).findFirst();
  }

  /** Returns the urls of a node with its code as the last one, as in VRML. */
  static String urls(@Nullable NodeType type, String urls, String code) {
    boolean script = type == null || type.is("X3DScriptNode");
    String last =
        script
            ? (language(code).isPresent() ? "" : SCRIPT + "\n") + code
            : SHADER + "\n" + code.replace("%", "%25");
    return urls.isEmpty() ? FieldTokenizer.string(last) : urls + " " + FieldTokenizer.string(last);
  }

  /** Parses the strings of an MFString. */
  static List<String> strings(String text) {
    Object value = new FieldParser().parse(FieldType.MFString, text).value();
    return value instanceof String[] all ? List.of(all) : List.of();
  }
}
