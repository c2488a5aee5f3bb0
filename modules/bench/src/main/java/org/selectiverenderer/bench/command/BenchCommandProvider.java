package org.selectiverenderer.bench.command;

import java.util.List;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.CommandContext;
import org.selectiverenderer.command.CommandProvider;

/** Offers the command {@code bench} to the program. */
public final class BenchCommandProvider implements CommandProvider {
  @Override
  public List<String> names() {
    return List.of("bench");
  }

  @Override
  public CliCommand create(String name, CommandContext context) {
    return new BenchCommand(context.console(), context.mainClass());
  }
}
