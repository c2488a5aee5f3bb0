package org.selectiverenderer.app.studies.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.studies.StudyCommands;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.swing.PlainText;

/**
 * The answers, collected into a folder, and the report on those about remembered objects, or on the
 * trials.
 */
final class ResultsPage extends JPanel {
  private static final long serialVersionUID = 1;

  /** Most files of the folder that are listed. */
  private static final int MOST = 200;

  private final transient StudyDesk desk;
  private final JTextField folder = new JTextField();
  private final ActionLine collect = new ActionLine("results.collect", this::collect);
  private final ActionLine analyse = new ActionLine("results.analyse", this::analyse);
  private final JButton open = StudyTexts.button("results.open");
  private final JTextArea told = new JTextArea(6, 40);
  private final DefaultListModel<String> files = new DefaultListModel<>();
  private transient Optional<Path> shown = Optional.empty();

  ResultsPage(StudyDesk desk) {
    super(
        new MigLayout(
            "insets 12, fill, wrap 1", "[grow,fill]", "[][][][][grow 40,fill][][grow 60,fill]"));
    this.desk = desk;
    folder.setName("results.folder");
    told.setName("results.told");
    told.setEditable(false);
    told.setLineWrap(true);
    told.setWrapStyleWord(true);
    told.getAccessibleContext().setAccessibleName(StudyTexts.of("results.told"));
    JPanel where = new JPanel(new MigLayout("insets 0, fillx", "[][grow,fill][]"));
    JLabel label = StudyTexts.label("results.folder");
    label.setLabelFor(folder);
    JButton choose = StudyTexts.button("results.choose");
    choose.addActionListener(event -> choose());
    where.add(label);
    where.add(folder);
    where.add(choose);
    open.addActionListener(event -> desk.browse(folder().resolve(StudyCommands.REPORT)));
    JList<String> list = PlainText.entries(new JList<>(files));
    list.setName("results.files");
    list.getAccessibleContext().setAccessibleName(StudyTexts.of("results.files"));
    add(where);
    add(collect);
    add(analyse);
    add(open, "grow 0");
    add(new JScrollPane(told), "grow, push, hmin 60");
    add(new JLabel(StudyTexts.of("results.files")));
    add(new JScrollPane(list), "grow, push, hmin 60");
    folder.addActionListener(event -> commands());
    folder.addCaretListener(event -> commands());
    desk.listen(this::show);
  }

  private Path folder() {
    return Path.of(folder.getText().strip());
  }

  private void show(Optional<StudyOverview> study) {
    Optional<Path> now = study.map(known -> known.study().file());
    if (!now.equals(shown)) {
      shown = now;
      told.setText("");
      files.clear();
      folder.setText(
          study
              .map(known -> known.study().folder().toAbsolutePath().resolve("results").toString())
              .orElse(""));
      commands();
      now.ifPresent(file -> listFiles());
    }
  }

  private void commands() {
    Optional<StudyCommands> commands =
        folder.getText().isBlank() ? Optional.empty() : desk.commands();
    boolean trials = desk.study().filter(StudyOverview::trials).isPresent();
    try {
      Path chosen = folder();
      collect.command(commands.map(each -> each.collect(chosen, trials)));
      analyse.command(commands.map(each -> each.analyse(chosen, trials)));
    } catch (InvalidPathException e) {
      collect.command(Optional.empty());
      analyse.command(Optional.empty());
    }
  }

  private void choose() {
    JFileChooser chooser = new JFileChooser(folder.getText().strip());
    chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
    if (chooser.showDialog(this, StudyTexts.of("choose")) == JFileChooser.APPROVE_OPTION) {
      folder.setText(chooser.getSelectedFile().toString());
      commands();
      listFiles();
    }
  }

  private void collect() {
    Path chosen = folder();
    told.setText("");
    collect.allow(false);
    desk.reader()
        .read(
            () -> Files.createDirectories(chosen),
            made -> collect(chosen),
            why -> {
              collect.allow(true);
              desk.say(why);
            });
  }

  private void collect(Path chosen) {
    boolean trials = desk.study().filter(StudyOverview::trials).isPresent();
    desk.commands()
        .ifPresent(
            commands ->
                desk.start(
                    commands.collect(chosen, trials),
                    this::tell,
                    status -> {
                      collect.allow(true);
                      listFiles();
                    },
                    process -> {}));
  }

  private void analyse() {
    Path chosen = folder();
    boolean trials = desk.study().filter(StudyOverview::trials).isPresent();
    told.setText("");
    analyse.allow(false);
    desk.commands()
        .ifPresent(
            commands ->
                desk.start(
                    commands.analyse(chosen, trials),
                    this::tell,
                    status -> analysed(chosen, status),
                    process -> {}));
  }

  private void analysed(Path chosen, int status) {
    analyse.allow(true);
    listFiles();
    if (status == 0) {
      tell(StudyTexts.of("results.done", chosen.resolve(StudyCommands.REPORT).toString()));
      desk.browse(chosen.resolve(StudyCommands.REPORT));
    }
  }

  private void tell(String line) {
    told.append(line + "\n");
  }

  /** Lists the folder's files, and whether it has a report. */
  private void listFiles() {
    Path chosen = folder();
    desk.reader().read(() -> names(chosen), this::listFiles, desk::say);
  }

  private static List<String> names(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> all = Files.list(folder)) {
      return all.filter(Files::isRegularFile)
          .limit(MOST)
          .map(file -> String.valueOf(file.getFileName()))
          .sorted()
          .toList();
    }
  }

  private void listFiles(List<String> names) {
    files.clear();
    files.addAll(names);
    open.setEnabled(names.contains(StudyCommands.REPORT));
  }
}
