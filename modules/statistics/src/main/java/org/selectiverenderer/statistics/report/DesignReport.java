package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;
import org.selectiverenderer.statistics.report.ReportBlock.Picture;
import org.selectiverenderer.statistics.report.ReportBlock.Section;
import org.selectiverenderer.statistics.report.ReportBlock.Table;

/**
 * Writes the report of the analyses of a study's design as text, HTML and JSON: of each whether it
 * was planned before, what it expects, what it leaves out, its cells and tests.
 */
public final class DesignReport {
  private final String title;
  private final List<Part> parts;
  private final List<String> remarks;
  private final AnovaOptions options;

  /**
   * An analysis.
   *
   * @param planned whether the study file planned it; else it is exploratory
   * @param hypothesis what was expected; empty if nothing was said
   * @param method what is measured, on which trials, and by which model, in one sentence
   * @param counts how many trials it has and leaves out, in sentences
   * @param anova the tests; empty where the design does not allow them
   * @param tables further tables, such as those of R
   */
  public record Part(
      String name,
      boolean planned,
      String hypothesis,
      String method,
      List<String> counts,
      FactorialDesign design,
      Optional<Anova> anova,
      List<Exclusion> exclusions,
      List<Cells> tables) {
    /** Copies the lists. */
    public Part {
      counts = List.copyOf(counts);
      exclusions = List.copyOf(exclusions);
      tables = List.copyOf(tables);
    }

    /** Returns the analysis with one more table. */
    public Part with(Cells table) {
      List<Cells> more = new ArrayList<>(tables);
      more.add(table);
      return new Part(name, planned, hypothesis, method, counts, design, anova, exclusions, more);
    }

    private String status() {
      return planned ? "as planned" : "exploratory";
    }
  }

  /** A table of text with rows as long as its header. */
  public record Cells(String caption, List<String> header, List<List<String>> rows) {
    /** Copies the rows. */
    public Cells {
      header = List.copyOf(header);
      rows = rows.stream().map(List::copyOf).toList();
    }
  }

  /**
   * @param remarks what holds for all analyses, in sentences
   */
  public DesignReport(String title, List<Part> parts, List<String> remarks, AnovaOptions options) {
    this.title = title;
    this.parts = List.copyOf(parts);
    this.remarks = List.copyOf(remarks);
    this.options = options;
  }

  /** Returns the report as plain text for a terminal. */
  public String text(DataSource source, Provenance provenance) {
    return TextReportWriter.of(title, blocks(source, provenance, false), true);
  }

  /** Returns the report as one self-contained HTML page. */
  public String html(DataSource source, Provenance provenance) {
    return HtmlReportWriter.of(title, blocks(source, provenance, true));
  }

  private List<ReportBlock> blocks(DataSource source, Provenance provenance, boolean pictures) {
    List<ReportBlock> blocks = new ArrayList<>(List.of(provenance.head(source)));
    if (!remarks.isEmpty()) {
      blocks.add(new Items(remarks));
    }
    parts.forEach(part -> blocks.add(section(part, pictures)));
    blocks.add(new Section("Methods", false, List.of(new Items(MethodsNotes.of(options)))));
    return blocks;
  }

  private static Section section(Part part, boolean pictures) {
    List<ReportBlock> blocks = new ArrayList<>();
    if (!part.planned()) {
      blocks.add(
          new Paragraph(
              "Exploratory: the study file does not plan this analysis. Its p values confirm"
                  + " nothing."));
    }
    if (!part.hypothesis().isEmpty()) {
      blocks.add(new Paragraph("Hypothesis: " + part.hypothesis()));
    }
    blocks.add(new Paragraph(part.method()));
    blocks.add(new Items(part.counts()));
    blocks.add(cells(part.design()));
    part.tables()
        .forEach(
            table ->
                blocks.add(new Table(table.caption(), table.header(), table.rows(), List.of())));
    if (part.anova().isPresent()) {
      Anova anova = part.anova().get();
      if (pictures) {
        blocks.add(
            new Picture(
                "Estimated marginal means with 95 % intervals (pooled error), and each participant.",
                new InteractionPlot().svg(anova, anova.design().measure())));
      }
      if (part.planned()) {
        List<ReportBlock> all = AnovaSection.of(anova, new BayesianAnova(anova).withRobustness());
        // The cells are above.
        blocks.addAll(all.subList(1, all.size()));
      } else {
        blocks.add(new EffectTables(anova, List.of()).effects());
      }
    } else {
      blocks.add(
          new Paragraph(
              "Not tested: %s.".formatted(part.design().obstacle().orElse("there are no tests"))));
    }
    if (!part.exclusions().isEmpty()) {
      blocks.add(AnovaReport.exclusions(part.exclusions()));
    }
    return new Section("%s (%s)".formatted(part.name(), part.status()), false, blocks);
  }

  private static Table cells(FactorialDesign design) {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (CellDescriptives cell : CellDescriptives.of(design)) {
      rows.add(
          List.of(
              cell.within().orElse("all"),
              design.between().varies() ? cell.between().orElse("total") : "all",
              cell.n() == 0 ? figures.dash("no participant") : figures.number(cell.mean(), 3),
              figures.number(cell.sd(), 3, Optional.of("fewer than two participants")),
              String.valueOf(cell.n())));
    }
    return new Table(
        "Cells: %s of participants".formatted(design.measure()),
        List.of(design.within().name(), design.between().name(), "mean", "SD", "n"),
        rows,
        figures.notes());
  }

  /** Returns the report as JSON. */
  public String json(DataSource source, Provenance provenance) {
    ObjectNode json = JsonTree.object().put("title", title);
    provenance.write(source, json);
    remarks.forEach(json.putArray("remarks")::add);
    ArrayNode analyses = json.putArray("analyses");
    for (Part part : parts) {
      ObjectNode node = analyses.addObject();
      node.put("name", part.name()).put("status", part.status());
      node.put("hypothesis", part.hypothesis()).put("method", part.method());
      part.counts().forEach(node.putArray("counts")::add);
      if (part.anova().isPresent()) {
        AnovaJsonWriter.write(part.anova().get(), new BayesianAnova(part.anova().get()), node);
      } else {
        node.put("measure", part.design().measure());
        AnovaJsonWriter.descriptives(part.design(), node);
        part.design().obstacle().ifPresent(reason -> node.put("undefined", reason));
      }
      ArrayNode tables = node.putArray("tables");
      for (Cells table : part.tables()) {
        ObjectNode written = tables.addObject().put("caption", table.caption());
        ArrayNode rows = written.putArray("rows");
        for (List<String> row : table.rows()) {
          ObjectNode cells = rows.addObject();
          for (int i = 0; i < row.size(); i++) {
            cells.put(table.header().get(i), row.get(i));
          }
        }
      }
      AnovaJsonWriter.exclusions(part.exclusions(), node);
    }
    AnovaJsonWriter.options(options, json.putObject("options"));
    return JsonWriter.of(json);
  }
}
