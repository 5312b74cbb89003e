"""What tools write into the documents: parts of pages between two marks, with the command, the machine and the date."""
