package org.selectiverenderer.command;

import java.util.List;
import java.util.Map;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi.Text;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * Formats the text of {@code --help}. Picocli breaks lines wherever Unicode allows it, as in the
 * middle of {@code --output=OUT.x3d}; this class breaks lines only at spaces. Examples are not
 * wrapped at all, so that they can be copied.
 */
public final class HelpFormatter extends Help {
  public HelpFormatter(CommandSpec command, ColorScheme colours) {
    super(command, colours);
  }

  @Override
  protected String insertSynopsisCommandName(int headingLength, Text options) {
    int heading = headingLength < 0 ? synopsisHeadingLength() : headingLength;
    String command = commandSpec().qualifiedName();
    WholeWords table = oneColumn();
    UsageMessageSpec usage = commandSpec().usageMessage();
    int below = heading + command.length() + 1; // the first word after the command
    boolean beside = below <= usage.synopsisAutoIndentThreshold() * usage.width();
    table.indentWrappedLines = beside ? below : heading;
    // The heading is printed by itself, before this.
    Text line = colorScheme().text("X".repeat(heading));
    table.addRowValues(line.concat(colorScheme().commandText(command)).concat(options));
    return table.toString().substring(heading);
  }

  @Override
  public String description(Object... values) {
    WholeWords table = oneColumn();
    table.indentWrappedLines = 0;
    for (String paragraph : commandSpec().usageMessage().description()) {
      for (Text line : colorScheme().text(String.format(paragraph, values)).splitLines()) {
        table.addRowValues(line);
      }
    }
    return table.toString();
  }

  @Override
  public String footer(Object... values) {
    StringBuilder lines = new StringBuilder();
    for (String line : commandSpec().usageMessage().footer()) {
      lines.append(colorScheme().text(String.format(line, values))).append(System.lineSeparator());
    }
    return lines.toString();
  }

  @Override
  public Layout createDefaultLayout(
      List<OptionSpec> options, List<PositionalParamSpec> parameters, ColorScheme colours) {
    Column[] columns =
        super.createDefaultLayout(options, parameters, colours).textTable().columns();
    return new Layout(colours, new WholeWords(colours, columns));
  }

  @Override
  public TextTable createTextTable(Map<?, ?> rows) {
    return new WholeWords(colorScheme(), super.createTextTable(rows).columns());
  }

  private WholeWords oneColumn() {
    int width = commandSpec().usageMessage().width();
    return new WholeWords(colorScheme(), new Column[] {new Column(width, 0, Column.Overflow.WRAP)});
  }

  /** A text table that wraps lines only at spaces. */
  private static final class WholeWords extends TextTable {
    private final ColorScheme colours;

    WholeWords(ColorScheme colours, Column[] columns) {
      super(colours, columns);
      this.colours = colours;
    }

    @Override
    public Cell putValue(int row, int column, Text value) {
      Column at = columns()[column];
      if (value == null || at.overflow != Column.Overflow.WRAP) {
        return super.putValue(row, column, value);
      }
      int room = at.width - at.indent;
      Text rest = value;
      int end = end(rest.plainString(), room);
      Cell last = super.putValue(row, column, rest.substring(0, end));
      for (rest = after(rest, end); !rest.plainString().isEmpty(); rest = after(rest, end)) {
        end = end(rest.plainString(), room - indentWrappedLines);
        addEmptyRow();
        Text indented = colours.text(" ".repeat(indentWrappedLines)).concat(rest.substring(0, end));
        last = super.putValue(last.row + 1, column, indented);
      }
      return last;
    }

    /** Returns where to break a text; picocli breaks a word that is longer than the line. */
    private static int end(String text, int room) {
      if (text.length() <= room) {
        return text.length();
      }
      int start = text.length() - text.stripLeading().length();
      int space = text.lastIndexOf(' ', room);
      int end = space > start ? space : text.indexOf(' ', start);
      return end < 0 ? text.length() : end;
    }

    private static Text after(Text text, int end) {
      String plain = text.plainString();
      int next = end;
      while (next < plain.length() && plain.charAt(next) == ' ') {
        next++;
      }
      return text.substring(next);
    }
  }
}
