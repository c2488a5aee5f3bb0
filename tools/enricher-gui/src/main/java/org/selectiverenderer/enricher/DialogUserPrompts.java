package org.selectiverenderer.enricher;

import java.awt.Window;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.diff.MergeDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.TrustDialog;
import org.selectiverenderer.x3d.model.ModelFormat;

/** Asks the author by modal dialogs over the window. */
final class DialogUserPrompts implements UserPrompts {

  private final Window owner;

  DialogUserPrompts(Window owner) {
    this.owner = owner;
  }

  private int choose(String sentence, String... choices) {
    return show(JOptionPane.QUESTION_MESSAGE, sentence, choices);
  }

  private int show(int kind, String sentence, String... choices) {
    JLabel said = new JLabel("<html><body width=420>" + MarkupEscaper.text(sentence));
    said.getAccessibleContext().setAccessibleName(sentence);
    return JOptionPane.showOptionDialog(
        owner,
        said,
        Texts.of("window.title"),
        JOptionPane.DEFAULT_OPTION,
        kind,
        null,
        choices,
        choices[0]);
  }

  @Override
  public Unsaved unsaved(String name) {
    return switch (choose(
        Texts.of("window.unsaved", name),
        Texts.of("window.save"),
        Texts.of("window.discard"),
        Texts.of("keep.cancel"))) {
      case 0 -> Unsaved.SAVE;
      case 1 -> Unsaved.DISCARD;
      default -> Unsaved.CANCEL;
    };
  }

  @Override
  public Left left(String sentence) {
    return switch (choose(
        sentence,
        Texts.of("window.restore"),
        Texts.of("window.discardkept"),
        Texts.of("window.later"))) {
      case 0 -> Left.RESTORE;
      case 1 -> Left.DISCARD;
      default -> Left.LATER;
    };
  }

  @Override
  public boolean convert(String sentence) {
    return choose(sentence, Texts.of("window.doconvert"), Texts.of("keep.cancel")) == 0;
  }

  @Override
  public boolean revert(String sentence) {
    return choose(sentence, Texts.of("keep.cancel"), Texts.of("window.revert.do")) == 1;
  }

  @Override
  public boolean overwrite(String sentence) {
    return choose(sentence, Texts.of("keep.cancel"), Texts.of("window.overwrite")) == 1;
  }

  @Override
  public OnDisk changedOnDisk(String sentence, List<OnDisk> among) {
    String[] names =
        among.stream()
            .map(
                answer ->
                    switch (answer) {
                      case KEEP ->
                          among.contains(OnDisk.OVERWRITE)
                              ? Texts.of("keep.cancel")
                              : Texts.of("merge.keep");
                      case OVERWRITE -> Texts.of("merge.overwrite");
                      case TAKE -> Texts.of("merge.take");
                      case MERGE -> Texts.of("merge.merge");
                    })
            .toArray(String[]::new);
    return among.get(Math.max(0, choose(sentence, names)));
  }

  @Override
  public Optional<List<ThreeWayMerge.Choice>> merge(ThreeWayMerge merge) {
    return new MergeDialog(owner, merge).decided();
  }

  @Override
  public LeftBehind leaveBehind(String sentence) {
    return switch (choose(
        sentence,
        Texts.of("package.take"),
        Texts.of("window.savethere"),
        Texts.of("keep.cancel"))) {
      case 0 -> LeftBehind.TAKE;
      case 1 -> LeftBehind.LEAVE;
      default -> LeftBehind.CANCEL;
    };
  }

  @Override
  public boolean without(String sentence, List<String> lines) {
    return listed(sentence, lines, Texts.of("package.without"));
  }

  @Override
  public boolean replace(String sentence, List<String> lines) {
    return listed(sentence, lines, Texts.of("package.replace"));
  }

  /** Shows a sentence over a list, and asks whether to go on. */
  private boolean listed(String sentence, List<String> lines, String goOn) {
    JList<String> list = PlainText.entries(new JList<>(lines.toArray(String[]::new)));
    list.setVisibleRowCount(Math.min(12, Math.max(3, lines.size())));
    list.getAccessibleContext().setAccessibleName(sentence);
    JPanel panel = new JPanel(new MigLayout("insets 0, fill, wrap 1", "[grow,fill]"));
    JLabel said = new JLabel("<html><body width=480>" + MarkupEscaper.text(sentence));
    said.getAccessibleContext().setAccessibleName(sentence);
    panel.add(said);
    panel.add(new JScrollPane(list), "grow, push, wmax 720");
    String[] choices = {Texts.of("keep.cancel"), goOn};
    return JOptionPane.showOptionDialog(
            owner,
            panel,
            Texts.of("window.title"),
            JOptionPane.DEFAULT_OPTION,
            JOptionPane.QUESTION_MESSAGE,
            null,
            choices,
            choices[0])
        == 1;
  }

  @Override
  public Optional<Path> modelToImport(Path scene) {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setDialogTitle(Texts.of("import.title"));
    chooser.setCurrentDirectory(scene.toAbsolutePath().getParent().toFile());
    chooser.setFileFilter(
        new FileNameExtensionFilter(
            Texts.of("import.models"),
            Stream.concat(endings(), models()).distinct().toArray(String[]::new)));
    return chosen(chooser, chooser.showDialog(owner, Texts.of("import.choose")));
  }

  @Override
  public boolean saveFaulty(String sentence) {
    return choose(sentence, Texts.of("keep.cancel"), Texts.of("keep.faulty.save")) == 1;
  }

  @Override
  public boolean trust(String sentence, List<String> lines) {
    return TrustDialog.ask(
            Optional.of(owner),
            new TrustDialog.Words(
                Texts.of("window.title"),
                sentence,
                Texts.of("keep.trusthint"),
                Texts.of("keep.agree"),
                Texts.of("keep.cancel")),
            lines)
        .orElse(false);
  }

  private static NamedFileChooser chooser(Optional<Path> near, Stream<String> endings) {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setFileFilter(
        new FileNameExtensionFilter(
            Texts.of("window.scenes"), endings.distinct().toArray(String[]::new)));
    near.ifPresent(path -> chooser.setSelectedFile(path.toAbsolutePath().toFile()));
    return chooser;
  }

  /**
   * The file extensions of scenes; .json and .xml count only where the author says that a file is a
   * scene.
   */
  private static Stream<String> endings() {
    return Stream.concat(FileFinder.SCENES.endings().stream(), Stream.of(".json", ".xml"))
        .map(ending -> ending.substring(ending.lastIndexOf('.') + 1));
  }

  private static Stream<String> models() {
    return Arrays.stream(ModelFormat.values()).map(ModelFormat::ending);
  }

  private static Optional<Path> chosen(NamedFileChooser chooser, int answer) {
    return answer == JFileChooser.APPROVE_OPTION && chooser.getSelectedFile() != null
        ? Optional.of(chooser.chosen())
        : Optional.empty();
  }

  @Override
  public Optional<Path> fileToOpen(Optional<Path> near) {
    // a model opens as a scene, and is saved as a new one
    NamedFileChooser chooser = chooser(near, Stream.concat(endings(), models()));
    return chosen(chooser, chooser.showOpenDialog(owner));
  }

  @Override
  public Optional<Path> fileToSave(Path near) {
    NamedFileChooser chooser = chooser(Optional.of(near), endings());
    return chosen(chooser, chooser.showSaveDialog(owner));
  }

  @Override
  public boolean review(EnricherSession session) {
    return new DiffDialog(owner, session).confirmed();
  }

  @Override
  public void tell(String sentence) {
    show(JOptionPane.WARNING_MESSAGE, Remarks.shown(sentence), Texts.of("window.ok"));
  }
}
