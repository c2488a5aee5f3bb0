package org.selectiverenderer.cli;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Scenes that are well-formed: each byte of the input says which node, field, value or end of a
 * node comes next, so that mutations get beyond the parser.
 */
public final class GeneratedSceneFuzzTarget {
  private static final List<NodeType> TYPES = NodeCatalogue.load().all();

  /** Values that readers have stumbled over, in any field. */
  private static final List<String> VALUES =
      List.of(
          "0",
          "-1",
          "1",
          "0 0 0",
          "1 0 0 0",
          "1e38",
          "-1e38 1e38 0",
          "NaN",
          "0 1 2 -1",
          "0 0 -1",
          "2147483647",
          "-2147483648",
          "3 3 4 1 2 3 4 5 6 7 8 9",
          "true",
          "\"a\" \"b\"",
          "1e-38",
          "0 0 0 1 1 1 0 1 0",
          "9 9",
          "",
          "0 0 0 0 1 1 1 1 1",
          "a",
          "DEFAULT");

  private GeneratedSceneFuzzTarget() {}

  /** Writes a scene of one input, and runs the commands on it. */
  public static void fuzzerTestOneInput(byte[] input) {
    CommandFuzzTarget.fuzzerTestOneInput(scene(input).getBytes(StandardCharsets.UTF_8));
  }

  static String scene(byte[] input) {
    StringBuilder xml = new StringBuilder("<X3D profile='Full' version='4.0'><Scene>\n");
    Deque<String> open = new ArrayDeque<>();
    int names = 0;
    int at = 0;
    while (at + 2 < input.length) {
      int action = input[at++] & 3;
      if (action == 3 && !open.isEmpty()) {
        xml.append("</").append(open.pop()).append(">\n");
        continue;
      }
      int which = (input[at++] & 0xff) << 8 | input[at++] & 0xff;
      NodeType type = TYPES.get(which % TYPES.size());
      xml.append('<').append(type.name());
      if (action == 2 && names > 0) {
        xml.append(" USE='N").append(which % names).append("'/>\n");
        continue;
      }
      xml.append(" DEF='N").append(names++).append('\'');
      List<FieldDefinition> fields = type.fields();
      for (int i = at < input.length ? input[at++] & 3 : 0; i > 0 && at + 1 < input.length; i--) {
        FieldDefinition field = fields.get((input[at++] & 0xff) % fields.size());
        String attribute = ' ' + field.name() + '=';
        if (xml.indexOf(attribute, xml.lastIndexOf("<")) < 0) {
          String value = VALUES.get((input[at++] & 0xff) % VALUES.size());
          xml.append(attribute).append('\'').append(value).append('\'');
        }
      }
      xml.append(">\n");
      open.push(type.name());
    }
    while (!open.isEmpty()) {
      xml.append("</").append(open.pop()).append(">\n");
    }
    return xml.append("</Scene></X3D>\n").toString();
  }
}
