# Reads the tables in this folder with the types of the codebook: levels become factors, in their
# order; times become POSIXct. Base R, no packages.
#
#   source("tables.R")
#   tables <- read_tables(".")
#   str(tables$gaze)

read_tables <- function(folder = ".") {
  read <- function(file) {
    table <- read.csv(file.path(folder, file), colClasses = "character", na.strings = "",
                      encoding = "UTF-8", check.names = FALSE)
    # An apostrophe says to spreadsheets that a text with = + - @, wide ones too, is no formula.
    formula <- "(?s)(^|[;\t\r\n])'(?='*[ \v\f\u00a0\u3000]*[=+@\uff1d\uff0b\uff0d\uff20-].)"
    table[] <- lapply(table, function(cells) gsub(formula, "\\1", cells, perl = TRUE))
    table
  }
  book <- read("codebook.csv")
  typed <- function(cells, row) {
    switch(row$type,
      "whole number" = as.integer(cells),
      "number" = as.numeric(cells),
      "category" = factor(cells, levels = strsplit(row$levels, "|", fixed = TRUE)[[1]]),
      "date and time" = as.POSIXct(sub("([+-][0-9]{2}):?([0-9]{2})$", "\\1\\2",
                                       sub("Z$", "+0000", cells)),
                                   format = "%Y-%m-%dT%H:%M:%OS%z", tz = "UTC"),
      cells)
  }
  tables <- list()
  for (file in unique(book$file)) {
    table <- read(file)
    rows <- book[book$file == file, ]
    for (i in seq_len(nrow(rows))) {
      table[[rows$column[i]]] <- typed(table[[rows$column[i]]], rows[i, ])
    }
    tables[[sub("\\.csv$", "", file)]] <- table
  }
  tables
}
